package org.pendant.controller.safety;

/**
 * Safety mode: what the safety functions do; names and codes are those of the controller's
 * interfaces.
 */
public enum SafetyMode {
  NORMAL(1),
  /** The reduced limits hold. */
  REDUCED(2),
  PROTECTIVE_STOP(3),
  /** The arm was switched on beyond a limit: it can be moved by hand, no program may run. */
  RECOVERY(4),
  SAFEGUARD_STOP(5),
  SYSTEM_EMERGENCY_STOP(6),
  ROBOT_EMERGENCY_STOP(7),
  /** A limit was exceeded. */
  VIOLATION(8),
  /** The safety functions cannot do their work. */
  FAULT(9),
  VALIDATE_JOINT_ID(10),
  UNDEFINED(11),
  AUTOMATIC_MODE_SAFEGUARD_STOP(12),
  SYSTEM_THREE_POSITION_ENABLING_STOP(13),
  TEACH_PENDANT_THREE_POSITION_ENABLING_STOP(14);

  private final int code;

  SafetyMode(int code) {
    this.code = code;
  }

  /** The number that interfaces report, from 1. */
  public int code() {
    return code;
  }
}
