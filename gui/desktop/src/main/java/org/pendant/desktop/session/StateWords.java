package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.util.Locale;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;

/** State words: modes and states as people read them. */
public final class StateWords {
  private StateWords() {}

  /** Such as {@code power off}. */
  public static String of(RobotMode mode) {
    return switch (mode) {
      case NO_CONTROLLER -> text("noController");
      case DISCONNECTED -> text("disconnected");
      case CONFIRM_SAFETY -> text("confirmSafety");
      case BOOTING -> text("booting");
      case POWER_OFF -> text("powerOff");
      case POWER_ON -> text("powerOn");
      case IDLE -> text("idle");
      case BACKDRIVE -> text("backdrive");
      case RUNNING -> text("running");
      case UPDATING_FIRMWARE -> text("updatingFirmware");
    };
  }

  /** Such as {@code protective stop}. */
  public static String of(SafetyMode mode) {
    return switch (mode) {
      case NORMAL -> text("normal");
      case REDUCED -> text("reduced");
      case PROTECTIVE_STOP -> text("protectiveStop");
      case RECOVERY -> text("recovery");
      case SAFEGUARD_STOP -> text("safeguardStop");
      case SYSTEM_EMERGENCY_STOP -> text("systemEmergencyStop");
      case ROBOT_EMERGENCY_STOP -> text("robotEmergencyStop");
      case VIOLATION -> text("violation");
      case FAULT -> text("fault");
      case VALIDATE_JOINT_ID -> text("validateJointId");
      case UNDEFINED -> text("undefined");
      case AUTOMATIC_MODE_SAFEGUARD_STOP -> text("automaticModeSafeguardStop");
      case SYSTEM_THREE_POSITION_ENABLING_STOP -> text("systemThreePositionEnablingStop");
      case TEACH_PENDANT_THREE_POSITION_ENABLING_STOP ->
          text("teachPendantThreePositionEnablingStop");
    };
  }

  /** With a capital letter at its start. */
  public static String capital(String words) {
    return words.isEmpty()
        ? words
        : words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
  }
}
