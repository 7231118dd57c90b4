package org.pendant.language.service;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Common functions: those that programs written by hand call most, in the order of how many of some
 * hundred public programs call them; what generated programs begin with is left out.
 */
final class CommonFunctions {
  private static final List<String> NAMES =
      List.of(
          "sync",
          "popup",
          "sleep",
          "socket_open",
          "str_cat",
          "movej",
          "set_tcp",
          "socket_send_string",
          "socket_read_string",
          "set_target_payload",
          "get_inverse_kin",
          "socket_set_var",
          "rpc_factory",
          "movel",
          "get_actual_tcp_pose",
          "sin",
          "sqrt",
          "cos",
          "acos",
          "norm",
          "pose_trans",
          "pose_add",
          "tan",
          "atan",
          "pose_sub",
          "set_standard_digital_out",
          "get_inverse_kin_has_solution",
          "get_actual_joint_positions",
          "get_target_waypoint",
          "normalize",
          "length",
          "movec",
          "stopl",
          "get_forward_kin",
          "socket_read_ascii_float",
          "socket_send_byte",
          "freedrive_mode",
          "tool_contact",
          "textmsg",
          "end_freedrive_mode",
          "get_target_tcp_speed",
          "socket_send_line",
          "socket_close",
          "floor",
          "request_boolean_from_primary_client",
          "get_standard_digital_in",
          "point_dist",
          "ceil",
          "servoj",
          "stopj",
          "get_steptime",
          "to_str",
          "pose_inv",
          "read_input_float_register",
          "read_input_integer_register",
          "movep",
          "speedl",
          "force_mode",
          "end_force_mode",
          "interpolate_pose",
          "zero_ftsensor");

  private static final Map<String, Integer> RANKS = ranks();

  private CommonFunctions() {}

  private static Map<String, Integer> ranks() {
    Map<String, Integer> ranks = new HashMap<>();
    NAMES.forEach(name -> ranks.put(name, ranks.size()));
    return Map.copyOf(ranks);
  }

  /** 0 for the one that most programs call; all that are not among them share the last rank. */
  static int rank(String name) {
    return RANKS.getOrDefault(name, RANKS.size());
  }
}
