package org.pendant.controller.state;

import java.util.Optional;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.safety.JointMode;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.script.vm.ProgramState;

/** Robot status bits: what a snapshot says in the numbers and bits that all interfaces report. */
public final class RobotBits {
  private static final int CONFIGURABLE_SHIFT = SignalBank.STANDARD_IN.size();
  private static final int TOOL_SHIFT = CONFIGURABLE_SHIFT + SignalBank.CONFIGURABLE_IN.size();

  private RobotBits() {}

  /** Whether the arm has power. */
  public static boolean powerOn(ControllerState state) {
    return powerOn(state.safety().robotMode());
  }

  /** Whether an arm in this mode has power. */
  static boolean powerOn(RobotMode mode) {
    return switch (mode) {
      case POWER_ON, IDLE, BACKDRIVE, RUNNING -> true;
      case NO_CONTROLLER, DISCONNECTED, CONFIRM_SAFETY, BOOTING, POWER_OFF, UPDATING_FIRMWARE ->
          false;
    };
  }

  /** Whether a program runs and is not paused. */
  public static boolean programRunning(ControllerState state) {
    return state.program().state() == ProgramState.RUNNING;
  }

  /** Whether it is guided by hand, at the arm or from the screen. */
  public static boolean teachButtonPressed(ControllerState state) {
    return state.freedrive().heldBy(FreedriveHolder.HAND)
        || state.freedrive().heldBy(FreedriveHolder.INPUT);
  }

  /** Bit 0 power on, 1 program running, 2 teach button pressed; bit 3, power button, is never. */
  public static int robotStatus(ControllerState state) {
    return bit(powerOn(state), 0)
        | bit(programRunning(state), 1)
        | bit(teachButtonPressed(state), 2);
  }

  /** Whether a protective stop is present. */
  public static boolean protectiveStopped(ControllerState state) {
    return state.safety().safetyMode() == SafetyMode.PROTECTIVE_STOP;
  }

  /** Whether an emergency stop is present, of the robot or the system. */
  public static boolean emergencyStopped(ControllerState state) {
    return isEmergency(state.safety().safetyMode());
  }

  /** Whether any safety function has stopped the arm. */
  public static boolean stoppedDueToSafety(ControllerState state) {
    return state.safety().stop().isPresent();
  }

  /**
   * Bit 0 normal, 1 reduced, 2 protective stop, 3 recovery, 4 safeguard stop, 5 system emergency
   * stop, 6 robot emergency stop, 7 either of these, 8 violation, 9 fault, 10 any stop; bit 11, the
   * input of an enabling device, is never.
   */
  public static int safetyStatus(ControllerState state) {
    SafetyMode mode = state.safety().safetyMode();
    return bit(mode == SafetyMode.NORMAL, 0)
        | bit(state.safety().reduced(), 1)
        | bit(mode == SafetyMode.PROTECTIVE_STOP, 2)
        | bit(mode == SafetyMode.RECOVERY, 3)
        | bit(coarse(mode) == SafetyMode.SAFEGUARD_STOP, 4)
        | bit(mode == SafetyMode.SYSTEM_EMERGENCY_STOP, 5)
        | bit(mode == SafetyMode.ROBOT_EMERGENCY_STOP, 6)
        | bit(isEmergency(mode), 7)
        | bit(mode == SafetyMode.VIOLATION, 8)
        | bit(mode == SafetyMode.FAULT, 9)
        | bit(stoppedDueToSafety(state), 10);
  }

  private static boolean isEmergency(SafetyMode mode) {
    return mode == SafetyMode.ROBOT_EMERGENCY_STOP || mode == SafetyMode.SYSTEM_EMERGENCY_STOP;
  }

  /** The mode as older interfaces know it: all kinds of safeguard stops are one. */
  public static SafetyMode coarse(SafetyMode mode) {
    return switch (mode) {
      case AUTOMATIC_MODE_SAFEGUARD_STOP,
          SYSTEM_THREE_POSITION_ENABLING_STOP,
          TEACH_PENDANT_THREE_POSITION_ENABLING_STOP ->
          SafetyMode.SAFEGUARD_STOP;
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
          UNDEFINED ->
          mode;
    };
  }

  /** The mode of a joint, 0 for the base to 5 for wrist 3. */
  public static JointMode jointMode(ControllerState state, int joint) {
    return JointMode.of(state.safety().robotMode(), state.safety().stop(), joint);
  }

  /** The mode of the tool flange's electronics: those of a joint that nothing is wrong with. */
  public static JointMode toolMode(ControllerState state) {
    RobotMode mode = state.safety().robotMode();
    Optional<SafetyStop> none = Optional.empty();
    JointMode joint = JointMode.of(mode, none, 0);
    return joint == JointMode.BACKDRIVE ? JointMode.RUNNING : joint;
  }

  /** Digital inputs: bits 0 to 7 standard, 8 to 15 configurable, 16 and 17 tool. */
  public static int digitalInputs(DigitalLevels levels) {
    return levels.standardIn()
        | levels.configurableIn() << CONFIGURABLE_SHIFT
        | levels.toolIn() << TOOL_SHIFT;
  }

  /** Digital outputs, as {@link #digitalInputs}. */
  public static int digitalOutputs(DigitalLevels levels) {
    return levels.standardOut()
        | levels.configurableOut() << CONFIGURABLE_SHIFT
        | levels.toolOut() << TOOL_SHIFT;
  }

  private static int bit(boolean set, int index) {
    return set ? 1 << index : 0;
  }
}
