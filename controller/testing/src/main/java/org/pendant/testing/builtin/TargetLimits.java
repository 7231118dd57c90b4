package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** Limits of targets: what tests cannot do to a robot that is reached by its ports, and why. */
public final class TargetLimits {
  /** What is read of a target as six numbers, by functions. */
  static final Map<String, String> VECTORS =
      Map.of(
          "get_actual_joint_positions", "actual_q",
          "get_actual_joint_speeds", "actual_qd",
          "get_target_joint_positions", "target_q",
          "get_target_joint_speeds", "target_qd",
          "get_actual_tcp_pose", "actual_TCP_pose",
          "get_actual_tcp_speed", "actual_TCP_speed",
          "get_target_tcp_pose", "target_TCP_pose",
          "get_target_tcp_speed", "target_TCP_speed",
          "get_tcp_force", "actual_TCP_force",
          "force", "actual_TCP_force");

  /** The first part of the names of analog quantities, by functions. */
  static final Map<String, String> ANALOGS =
      Map.of(
          "get_standard_analog_in", "standard_analog_input",
          "get_standard_analog_out", "standard_analog_output",
          "get_tool_analog_in", "tool_analog_input");

  /** What the target tells or does, beside these. */
  private static final Set<String> AT_TARGET =
      Set.of(
          "get_standard_digital_in",
          "get_standard_digital_out",
          "get_configurable_digital_in",
          "get_configurable_digital_out",
          "get_tool_digital_in",
          "get_tool_digital_out",
          "get_digital_in",
          "get_digital_out",
          "read_input_boolean_register",
          "read_input_integer_register",
          "read_input_float_register",
          "read_output_boolean_register",
          "read_output_integer_register",
          "read_output_float_register",
          "write_input_boolean_register",
          "write_input_integer_register",
          "write_input_float_register",
          "set_speed_slider",
          "assert_io_order",
          "tcp_inside",
          "robot_time",
          "safety_mode",
          "expect_safety_stop",
          "unlock_protective_stop",
          "start",
          "wait_for_end",
          "assert_program_fails",
          "stop_program",
          "pause_program",
          "resume_program",
          "program_running",
          "program_paused",
          "program_variable",
          "hold_popups",
          "popup_open",
          "close_popup",
          "log_contains",
          "assert_log");

  /** What the test does by itself, wherever its program runs. */
  private static final Set<String> HERE =
      Set.of(
          "assert_true",
          "assert_false",
          "fail",
          "skip",
          "expect_failure",
          "eventually",
          "always",
          "never",
          ExpectationBuiltins.IMPORT,
          "sleep",
          "sync",
          "textmsg",
          "get_steptime",
          "random");

  private TargetLimits() {}

  /** Why a function cannot be called by a test of a target; empty where it can. */
  public static Optional<String> reason(Builtins<ControlBox> builtins, String function) {
    Optional<Builtin<ControlBox>> found = builtins.find(function);
    // what is hidden stands in lines that are made, of all tests of a file alike
    if (found.isEmpty()
        || TestBuiltins.isHidden(function)
        || AT_TARGET.contains(function)
        || HERE.contains(function)
        || VECTORS.containsKey(function)
        || ANALOGS.containsKey(function)) {
      return Optional.empty();
    }
    boolean ofTests = found.get().signature().module().equals(TestBuiltins.MODULE);
    if (found.get().effect() == Effect.COMPUTES && !usesArm(found.get())) {
      return Optional.empty();
    }
    return Optional.of(TestTexts.text(ofTests ? ofTests(function) : ofBox(found.get()), function));
  }

  /**
   * Why a function cannot be called by a test that is sent as a whole; empty where it can.
   *
   * @param sent the functions of tests that are sent with it
   */
  public static Optional<String> reasonSent(
      Builtins<ControlBox> builtins, String function, Set<String> sent) {
    boolean fine =
        sent.contains(function)
            || function.equals(ExpectationBuiltins.IMPORT)
            || TestBuiltins.isHidden(function)
            || builtins
                .find(function)
                .filter(each -> each.signature().module().equals(TestBuiltins.MODULE))
                .isEmpty();
    if (fine) {
      return Optional.empty();
    }
    Optional<String> reason = reason(builtins, function);
    return reason.isPresent() ? reason : Optional.of(text("sentAsWhole", function));
  }

  /** Whether it computes with the arm of the controller here, which need not be the target's. */
  private static boolean usesArm(Builtin<ControlBox> builtin) {
    return builtin.name().contains("_kin") || builtin.name().contains("waypoint");
  }

  /** The text that says why a function for tests cannot be called. */
  private static String ofTests(String function) {
    if (function.contains("mock")) {
      return "limitMocks";
    }
    if (function.startsWith("peer_") || function.equals("listen")) {
      return "limitPeers";
    }
    if (function.startsWith("device_") || function.equals("modbus_device")) {
      return "limitDevices";
    }
    if (function.startsWith("rpc_")) {
      return "limitProcedures";
    }
    if (function.startsWith("any_") || function.equals("assume")) {
      return "limitGenerators";
    }
    return switch (function) {
      case "wire", "set_standard_digital_in", "set_configurable_digital_in" -> "limitInputs";
      case "set_tool_digital_in", "set_standard_analog_in", "set_tool_analog_in" -> "limitInputs";
      case "add_device",
          "put_part",
          "finger_opening",
          "finger_force",
          "object_pose",
          "object_there" ->
          "limitCell";
      case "answer" -> "limitAnswers";
      case "safety_message" -> "limitWords";
      default -> "limitPeople";
    };
  }

  /** The text that says why another function cannot be called. */
  private static String ofBox(Builtin<ControlBox> builtin) {
    return switch (builtin.effect()) {
      case ASKS, SENSES, ASKS_GOAL, COMPUTES -> "limitReads";
      case TELLS, SETS, MOVES, CHANGES -> "limitChanges";
    };
  }
}
