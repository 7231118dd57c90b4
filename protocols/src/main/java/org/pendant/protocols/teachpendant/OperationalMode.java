package org.pendant.protocols.teachpendant;

/** Operational mode: whether a person works beside the robot or not. */
public enum OperationalMode {
  /** The robot has no such modes, or none has been chosen. */
  NONE,
  MANUAL,
  AUTOMATIC
}
