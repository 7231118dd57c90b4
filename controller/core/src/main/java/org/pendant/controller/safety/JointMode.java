package org.pendant.controller.safety;

import java.util.Optional;

/** Joint mode: what a joint does; names and codes are those of the controller's interfaces. */
public enum JointMode {
  BACKDRIVE(238),
  POWER_OFF(239),
  BOOTING(247),
  VIOLATION(251),
  FAULT(252),
  RUNNING(253),
  /** Powered, on its brake. */
  IDLE(255);

  private final int code;

  JointMode(int code) {
    this.code = code;
  }

  /** The number that interfaces report. */
  public int code() {
    return code;
  }

  /**
   * The mode of a joint.
   *
   * @param mode of the robot
   * @param stop the present stop
   * @param joint 0 for the base to 5 for wrist 3
   */
  public static JointMode of(RobotMode mode, Optional<SafetyStop> stop, int joint) {
    if (stop.isPresent() && stop.get().joint().orElse(joint) == joint) {
      if (stop.get().mode() == SafetyMode.VIOLATION) {
        return VIOLATION;
      }
      if (stop.get().mode() == SafetyMode.FAULT) {
        return FAULT;
      }
    }
    return switch (mode) {
      case RUNNING -> RUNNING;
      case IDLE -> IDLE;
      case BOOTING, POWER_ON -> BOOTING;
      case BACKDRIVE -> BACKDRIVE;
      case POWER_OFF, NO_CONTROLLER, DISCONNECTED, CONFIRM_SAFETY, UPDATING_FIRMWARE -> POWER_OFF;
    };
  }
}
