package org.pendant.protocols.dashboard;

import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.state.RobotBits;

/** Safety mode names of the dashboard server. */
final class SafetyModeNames {
  private SafetyModeNames() {}

  /** With all differences. */
  static String status(SafetyMode mode) {
    return switch (mode) {
      case UNDEFINED -> "UNDEFINED_SAFETY_MODE";
      case TEACH_PENDANT_THREE_POSITION_ENABLING_STOP -> "TP_THREE_POSITION_ENABLING_STOP";
      case NORMAL,
          REDUCED,
          PROTECTIVE_STOP,
          RECOVERY,
          SAFEGUARD_STOP,
          SYSTEM_EMERGENCY_STOP,
          ROBOT_EMERGENCY_STOP,
          VIOLATION,
          FAULT,
          VALIDATE_JOINT_ID,
          AUTOMATIC_MODE_SAFEGUARD_STOP,
          SYSTEM_THREE_POSITION_ENABLING_STOP ->
          mode.name();
    };
  }

  /** With one name for everything that is a safeguard stop. */
  static String mode(SafetyMode mode) {
    return status(RobotBits.coarse(mode));
  }
}
