package org.pendant.protocols.teachpendant;

/** Who is meant to work with the robot: somebody beside it, or nobody. */
public enum OperationalMode {
  /** The robot has no such modes, or nobody has chosen one. */
  NONE,
  MANUAL,
  AUTOMATIC
}
