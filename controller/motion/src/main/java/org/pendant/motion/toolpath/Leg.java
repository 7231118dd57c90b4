package org.pendant.motion.toolpath;

import org.pendant.motion.ToolCurve;

/**
 * Leg of a toolpath: leads from one waypoint to the next.
 *
 * @param curve in the work frame
 * @param length the parameter at its end, above 0: metres, or more where the tool mostly turns
 * @param pace how fast, and how its end may be cut
 * @param name of the motion that it belongs to, for messages
 */
record Leg(ToolCurve curve, double length, Limits pace, String name) {

  /**
   * How fast a leg is.
   *
   * @param accelerationMPerS2 of the tool, above 0
   * @param speedMPerS of the tool, above 0
   * @param radiusM of the blend at its end, 0 for none
   * @param inner whether its end is a point within a toolpath, where a shallow corner is no reason
   *     to stop
   */
  record Limits(double accelerationMPerS2, double speedMPerS, double radiusM, boolean inner) {}
}
