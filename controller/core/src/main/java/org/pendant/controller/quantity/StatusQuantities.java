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
    list.group("controller");
    addController(list);
    list.group("modes");
    addModes(list);
    addFlags(list);
  }

  private static void addController(QuantityList list) {
    list.number("timestamp", "time", SECOND, ControllerState::timeS).rtde("timestamp");
    list.number("speed_scaling", "speedScaling", RATIO, StatusQuantities::speedScaling)
        .explained("speedScalingExplained")
        .rtde("speed_scaling");
    list.number("motion_scaling", "motionScaling", RATIO, s -> s.arm().speedScaling())
        .explained("motionScalingExplained");
    list.number("speed_slider", "speedSlider", RATIO, s -> s.arm().speedFraction())
        .rtde("target_speed_fraction");
    list.whole(
            "time_scale_source",
            "timeScaleSource",
            INT32,
            s -> s.arm().speedScaling() < s.arm().speedFraction() ? 1 : 0)
        .explained("timeScaleSourceExplained")
        .rtde("time_scale_source");
    list.whole("program_line", "programLine", UINT32, s -> s.program().line())
        .rtde("script_control_line");
    list.whole("control_step", "controlStep", UINT64, ControllerState::frame).rtde("control_step");
    list.number("execution_time", "executionTime", MILLISECOND, s -> MILLI * s.executionTimeS())
        .explained("executionTimeExplained")
        .rtde(Published.EXECUTION_TIME);
    list.number(
            "target_execution_time",
            "targetExecutionTime",
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
    list.whole("robot_mode", "robotMode", INT32, s -> s.safety().robotMode().code())
        .rtde("robot_mode");
    list.whole(
            "safety_mode",
            "safetyMode",
            INT32,
            s -> RobotBits.coarse(s.safety().safetyMode()).code())
        .explained("safetyModeExplained")
        .rtde("safety_mode");
    list.whole("safety_status", "safetyStatus", INT32, s -> s.safety().safetyMode().code())
        .rtde("safety_status");
    list.whole("robot_status_bits", "robotStatusBits", UINT32, RobotBits::robotStatus)
        .rtde("robot_status_bits");
    list.whole("safety_status_bits", "safetyStatusBits", UINT32, RobotBits::safetyStatus)
        .rtde("safety_status_bits");
    list.whole("runtime_state", "runtimeState", UINT32, s -> s.program().runtime().code())
        .rtde("runtime_state");
    list.whole("control_mode", "controlMode", INT32, s -> s.arm().controlMode().code())
        .explained("controlModeExplained");
    list.whole("tool_mode", "toolMode", UINT32, s -> RobotBits.toolMode(s).code())
        .rtde("tool_mode");
    list.whole("safety_checksum", "safetyChecksum", INT32, s -> s.safety().checksum().value());
  }

  private static void addFlags(QuantityList list) {
    list.flag("power_on", "powerOn", s -> RobotBits.powerOn(s) ? 1 : 0);
    list.flag("program_running", "programRuns", s -> RobotBits.programRunning(s) ? 1 : 0);
    list.flag(
        "program_paused",
        "programIsPaused",
        s -> s.program().state() == ProgramState.PAUSED ? 1 : 0);
    list.flag("reduced", "reducedLimits", s -> s.safety().reduced() ? 1 : 0);
    list.flag("protective_stopped", "protectiveStop", s -> RobotBits.protectiveStopped(s) ? 1 : 0);
    list.flag("emergency_stopped", "emergencyStop", s -> RobotBits.emergencyStopped(s) ? 1 : 0);
    list.flag("safety_stopped", "stoppedForSafety", s -> RobotBits.stoppedDueToSafety(s) ? 1 : 0);
    list.flag("teach_button", "teachButton", s -> RobotBits.teachButtonPressed(s) ? 1 : 0)
        .explained("teachButtonExplained");
    list.flag(
        "freedrive_input",
        "freedriveByInput",
        s -> s.freedrive().heldBy(FreedriveHolder.INPUT) ? 1 : 0);
  }
}
