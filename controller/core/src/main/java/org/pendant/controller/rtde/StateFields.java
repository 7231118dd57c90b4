package org.pendant.controller.rtde;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;

/** Fields about modes, the program and the controller itself. */
final class StateFields {
  private static final double MICRO = 1e6;

  private StateFields() {}

  static void addTo(FieldList list) {
    list.int32("robot_mode", state -> state.safety().robotMode().code());
    list.int32("safety_mode", state -> RobotBits.coarse(state.safety().safetyMode()).code());
    list.int32("safety_status", state -> state.safety().safetyMode().code());
    list.uint32("robot_status_bits", RobotBits::robotStatus);
    list.uint32("safety_status_bits", RobotBits::safetyStatus);
    list.uint32("runtime_state", state -> state.program().runtime().code());
    list.uint32("script_control_line", state -> state.program().line());
    list.number("speed_scaling", state -> state.arm().speedScaling());
    list.number("target_speed_fraction", state -> state.arm().speedFraction());
    list.int32("time_scale_source", StateFields::timeScaleSource);
    list.number(OutputFields.EXECUTION_TIME, state -> MICRO * state.executionTimeS());
    list.number("target_execution_time", state -> MICRO * ControlBox.FRAME_S);
    list.add("control_step", FieldType.UINT64, (state, out) -> out.putLong(state.frame()));
  }

  /** 1 while something beyond the speed slider makes the arm slower: a pause, a stop, a limit. */
  private static int timeScaleSource(ControllerState state) {
    return state.arm().speedScaling() < state.arm().speedFraction() ? 1 : 0;
  }
}
