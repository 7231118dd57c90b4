package org.pendant.motion;

/**
 * Path caps: the highest speed and acceleration that an arm is capable of along a whole path.
 *
 * @param rate highest first derivative of the path's parameter by time, per s, above 0
 * @param rate2 highest second derivative, per s², above 0
 */
record PathCaps(double rate, double rate2) {
  /** No cap at all. */
  static final PathCaps NONE = new PathCaps(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
}
