package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Launch arguments: what a client wants to debug, and on what.
 *
 * @param program file of a script or a tree
 * @param test the name of a test in it; empty for a program
 * @param options as {@code pendant run} has them
 * @param stopOnEntry whether it is held before its first statement
 * @param stopAtEnd whether it is held once more when it has ended, to be looked back at
 * @param noDebug whether nothing is to stop it
 */
record LaunchArguments(
    String program,
    Optional<String> test,
    List<String> options,
    boolean stopOnEntry,
    boolean stopAtEnd,
    boolean noDebug) {
  LaunchArguments {
    options = List.copyOf(options);
  }

  /**
   * Reads the arguments of a request. Keys that are not known belong to the client.
   *
   * @throws IllegalArgumentException if one is of another kind
   */
  static LaunchArguments of(Map<String, Object> told) {
    JsonArguments arguments = new JsonArguments(told);
    String program =
        arguments
            .text("program")
            .orElseThrow(() -> new IllegalArgumentException(text("programMissing")));
    List<String> options = new ArrayList<>();
    for (String name : List.of("robot", "installation", "scene")) {
      arguments.text(name).ifPresent(value -> add(options, name, value));
    }
    arguments.scalar("speed").ifPresent(value -> add(options, "speed", value));
    arguments.pairs("inputs").forEach(pair -> add(options, "input", pair));
    arguments.pairs("answers").forEach(pair -> add(options, "answer", pair));
    options.addAll(arguments.texts("args"));
    return new LaunchArguments(
        program,
        arguments.text("test"),
        options,
        arguments.flag("stopOnEntry"),
        arguments.flag("stopAtEnd"),
        arguments.flag("noDebug"));
  }

  private static void add(List<String> options, String name, String value) {
    options.add("--" + name + "=" + value);
  }

  /** Another program or other options, where a client names them for a restart. */
  static LaunchArguments again(LaunchArguments before, Optional<Map<String, Object>> told) {
    return told.filter(each -> each.containsKey("program")).map(LaunchArguments::of).orElse(before);
  }
}
