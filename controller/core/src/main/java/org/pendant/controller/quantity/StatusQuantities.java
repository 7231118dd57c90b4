package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.PhysicalUnit.MICROSECOND;
import static org.pendant.controller.quantity.PhysicalUnit.RATIO;
import static org.pendant.controller.quantity.PhysicalUnit.SECOND;
import static org.pendant.controller.quantity.ScalarType.INT32;
import static org.pendant.controller.quantity.ScalarType.UINT32;
import static org.pendant.controller.quantity.ScalarType.UINT64;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;
import org.pendant.script.vm.ProgramState;

/** Quantities of modes, the program and the controller itself. */
final class StatusQuantities {
  private static final String CONTROLLER = "Controller";
  private static final String MODES = "Modes";
  private static final double MICRO = 1e6;

  private StatusQuantities() {}

  static void declareIn(QuantityList list) {
    addController(list);
    addModes(list);
    addFlags(list);
  }

  private static void addController(QuantityList list) {
    list.number("timestamp", CONTROLLER, "Time", SECOND, ControllerState::timeS).rtde("timestamp");
    list.number("speed_scaling", CONTROLLER, "Speed scaling", RATIO, s -> s.arm().speedScaling())
        .explained("How fast motion time runs against the clock")
        .rtde("speed_scaling");
    list.number("speed_slider", CONTROLLER, "Speed slider", RATIO, s -> s.arm().speedFraction())
        .rtde("target_speed_fraction");
    list.whole(
            "time_scale_source",
            CONTROLLER,
            "Time scale source",
            INT32,
            s -> s.arm().speedScaling() < s.arm().speedFraction() ? 1 : 0)
        .explained("1 while a pause, a stop or a limit makes the arm slower than the slider does")
        .rtde("time_scale_source");
    list.whole("program_line", CONTROLLER, "Program line", UINT32, s -> s.program().line())
        .rtde("script_control_line");
    list.whole("control_step", CONTROLLER, "Control step", UINT64, ControllerState::frame)
        .rtde("control_step");
    list.number(
            "execution_time",
            CONTROLLER,
            "Execution time",
            MICROSECOND,
            s -> MICRO * s.executionTimeS())
        .explained("How long the computer worked at the frame")
        .rtde("actual_execution_time");
    list.number(
            "target_execution_time",
            CONTROLLER,
            "Target execution time",
            MICROSECOND,
            s -> MICRO * ControlBox.FRAME_S)
        .rtde("target_execution_time");
  }

  private static void addModes(QuantityList list) {
    list.whole("robot_mode", MODES, "Robot mode", INT32, s -> s.safety().robotMode().code())
        .rtde("robot_mode");
    list.whole(
            "safety_mode",
            MODES,
            "Safety mode",
            INT32,
            s -> RobotBits.coarse(s.safety().safetyMode()).code())
        .explained("As older interfaces know it")
        .rtde("safety_mode");
    list.whole("safety_status", MODES, "Safety status", INT32, s -> s.safety().safetyMode().code())
        .rtde("safety_status");
    list.whole("robot_status_bits", MODES, "Robot status bits", UINT32, RobotBits::robotStatus)
        .rtde("robot_status_bits");
    list.whole("safety_status_bits", MODES, "Safety status bits", UINT32, RobotBits::safetyStatus)
        .rtde("safety_status_bits");
    list.whole("runtime_state", MODES, "Runtime state", UINT32, s -> s.program().runtime().code())
        .rtde("runtime_state");
    list.whole("control_mode", MODES, "Control mode", INT32, s -> s.arm().controlMode().code())
        .explained("What the drives follow");
    list.whole("tool_mode", MODES, "Tool mode", UINT32, s -> RobotBits.toolMode(s).code())
        .rtde("tool_mode");
    list.whole(
        "safety_checksum", MODES, "Safety checksum", INT32, s -> s.safety().checksum().value());
  }

  private static void addFlags(QuantityList list) {
    list.flag("power_on", MODES, "Power on", s -> RobotBits.powerOn(s) ? 1 : 0);
    list.flag("program_running", MODES, "Program runs", s -> RobotBits.programRunning(s) ? 1 : 0);
    list.flag(
        "program_paused",
        MODES,
        "Program is paused",
        s -> s.program().state() == ProgramState.PAUSED ? 1 : 0);
    list.flag("reduced", MODES, "Reduced limits", s -> s.safety().reduced() ? 1 : 0);
    list.flag(
        "protective_stopped",
        MODES,
        "Protective stop",
        s -> RobotBits.protectiveStopped(s) ? 1 : 0);
    list.flag(
        "emergency_stopped", MODES, "Emergency stop", s -> RobotBits.emergencyStopped(s) ? 1 : 0);
    list.flag(
        "safety_stopped",
        MODES,
        "Stopped for safety",
        s -> RobotBits.stoppedDueToSafety(s) ? 1 : 0);
    list.flag("teach_button", MODES, "Teach button", s -> RobotBits.teachButtonPressed(s) ? 1 : 0)
        .explained("Guided by hand, at the arm or from the screen");
    list.flag(
        "freedrive_input",
        MODES,
        "Freedrive by input",
        s -> s.freedrive().heldBy(FreedriveHolder.INPUT) ? 1 : 0);
  }
}
