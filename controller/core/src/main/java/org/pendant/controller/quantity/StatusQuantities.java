package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.PhysicalUnit.MILLISECOND;
import static org.pendant.controller.quantity.PhysicalUnit.RATIO;
import static org.pendant.controller.quantity.PhysicalUnit.SECOND;
import static org.pendant.controller.quantity.ScalarType.INT32;
import static org.pendant.controller.quantity.ScalarType.UINT32;
import static org.pendant.controller.quantity.ScalarType.UINT64;

import org.pendant.controller.box.Published;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;
import org.pendant.models.time.FrameTime;
import org.pendant.script.vm.ProgramState;

/** Quantities of modes, the program and the controller itself. */
final class StatusQuantities {
  private static final double MILLI = 1e3;

  private StatusQuantities() {}

  static void declareIn(QuantityList list) {
    list.group("Controller");
    addController(list);
    list.group("Modes");
    addModes(list);
    addFlags(list);
  }

  private static void addController(QuantityList list) {
    list.number("timestamp", "Time", SECOND, ControllerState::timeS).rtde("timestamp");
    list.number("speed_scaling", "Speed scaling", RATIO, StatusQuantities::speedScaling)
        .explained("Motion scaling of a program; 0 without one and while it is paused")
        .rtde("speed_scaling");
    list.number("motion_scaling", "Motion scaling", RATIO, s -> s.arm().speedScaling())
        .explained("How fast motion time runs against the clock");
    list.number("speed_slider", "Speed slider", RATIO, s -> s.arm().speedFraction())
        .rtde("target_speed_fraction");
    list.whole(
            "time_scale_source",
            "Time scale source",
            INT32,
            s -> s.arm().speedScaling() < s.arm().speedFraction() ? 1 : 0)
        .explained("1 while a pause, a stop or a limit makes the arm slower than the slider does")
        .rtde("time_scale_source");
    list.whole("program_line", "Program line", UINT32, s -> s.program().line())
        .rtde("script_control_line");
    list.whole("control_step", "Control step", UINT64, ControllerState::frame).rtde("control_step");
    list.number("execution_time", "Execution time", MILLISECOND, s -> MILLI * s.executionTimeS())
        .explained("How long the computer worked at the frame")
        .rtde(Published.EXECUTION_TIME);
    list.number(
            "target_execution_time",
            "Target execution time",
            MILLISECOND,
            s -> MILLI * FrameTime.FRAME_S)
        .rtde("target_execution_time");
  }

  /** 0 without a program and while it is paused. */
  private static double speedScaling(ControllerState state) {
    return switch (state.program().runtime()) {
      case STOPPED, PAUSED -> 0;
      case STOPPING, PLAYING, PAUSING, RESUMING -> state.arm().speedScaling();
    };
  }

  private static void addModes(QuantityList list) {
    list.whole("robot_mode", "Robot mode", INT32, s -> s.safety().robotMode().code())
        .rtde("robot_mode");
    list.whole(
            "safety_mode",
            "Safety mode",
            INT32,
            s -> RobotBits.coarse(s.safety().safetyMode()).code())
        .explained("As older interfaces know it")
        .rtde("safety_mode");
    list.whole("safety_status", "Safety status", INT32, s -> s.safety().safetyMode().code())
        .rtde("safety_status");
    list.whole("robot_status_bits", "Robot status bits", UINT32, RobotBits::robotStatus)
        .rtde("robot_status_bits");
    list.whole("safety_status_bits", "Safety status bits", UINT32, RobotBits::safetyStatus)
        .rtde("safety_status_bits");
    list.whole("runtime_state", "Runtime state", UINT32, s -> s.program().runtime().code())
        .rtde("runtime_state");
    list.whole("control_mode", "Control mode", INT32, s -> s.arm().controlMode().code())
        .explained("What the drives follow");
    list.whole("tool_mode", "Tool mode", UINT32, s -> RobotBits.toolMode(s).code())
        .rtde("tool_mode");
    list.whole("safety_checksum", "Safety checksum", INT32, s -> s.safety().checksum().value());
  }

  private static void addFlags(QuantityList list) {
    list.flag("power_on", "Power on", s -> RobotBits.powerOn(s) ? 1 : 0);
    list.flag("program_running", "Program runs", s -> RobotBits.programRunning(s) ? 1 : 0);
    list.flag(
        "program_paused",
        "Program is paused",
        s -> s.program().state() == ProgramState.PAUSED ? 1 : 0);
    list.flag("reduced", "Reduced limits", s -> s.safety().reduced() ? 1 : 0);
    list.flag("protective_stopped", "Protective stop", s -> RobotBits.protectiveStopped(s) ? 1 : 0);
    list.flag("emergency_stopped", "Emergency stop", s -> RobotBits.emergencyStopped(s) ? 1 : 0);
    list.flag("safety_stopped", "Stopped for safety", s -> RobotBits.stoppedDueToSafety(s) ? 1 : 0);
    list.flag("teach_button", "Teach button", s -> RobotBits.teachButtonPressed(s) ? 1 : 0)
        .explained("Guided by hand, at the arm or from the screen");
    list.flag(
        "freedrive_input",
        "Freedrive by input",
        s -> s.freedrive().heldBy(FreedriveHolder.INPUT) ? 1 : 0);
  }
}
