package org.pendant.project.program.script;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.signature.Signature;
import org.pendant.project.program.TreeNames;

/**
 * Script names: the names in a script. What people call things need not be names of the language,
 * so each gets one: legal, and that of nothing else.
 */
final class ScriptNames {
  private static final Set<String> KEYWORDS =
      Set.of(
          ("def sec thread end if elif else while break continue return halt pause run join kill"
                  + " enter_critical exit_critical global local and or xor not True False None")
              .split(" "));

  private static final Set<String> BUILTINS =
      StandardBuiltins.create().all().stream()
          .map(Signature::name)
          .collect(Collectors.toUnmodifiableSet());

  private static final Pattern LEGAL = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private final Set<String> taken = new HashSet<>();
  private final Map<String, String> variables = new HashMap<>();
  private final Map<String, String> waypoints = new HashMap<>();
  private final Map<String, String> functions = new HashMap<>();
  private final Set<String> handles = new HashSet<>();
  private final Map<String, Integer> counts = new HashMap<>();
  private final Set<String> made = new HashSet<>();

  /** Keeps names for what people have typed; they are given to nothing else. */
  void reserve(Collection<String> names) {
    taken.addAll(names);
  }

  /** The variable that people call that: its very name if the language allows it. */
  String variable(String wanted) {
    return variables.computeIfAbsent(wanted, this::newVariable);
  }

  private String newVariable(String wanted) {
    String name = wanted.strip();
    if (LEGAL.matcher(name).matches() && !KEYWORDS.contains(name)) {
      taken.add(name);
      return name;
    }
    String legal = unique(name, "variable");
    made.remove(legal);
    return legal;
  }

  /** The names that the script needs besides those that people gave, so far. */
  Set<String> made() {
    return Set.copyOf(made);
  }

  /** The variable with the pose of a waypoint. */
  String pose(String waypoint) {
    return waypoint(waypoint) + "_p";
  }

  /** The variable with the joint positions of a waypoint. */
  String joints(String waypoint) {
    return waypoint(waypoint) + "_q";
  }

  private String waypoint(String waypoint) {
    return waypoints.computeIfAbsent(waypoint, this::newWaypoint);
  }

  private String newWaypoint(String waypoint) {
    String stem = TreeNames.place(waypoint);
    String name = stem;
    for (int i = 2; isTaken(name + "_p") || isTaken(name + "_q"); i++) {
      name = stem + "_" + i;
    }
    add(name + "_p");
    add(name + "_q");
    return name;
  }

  /** The function of a sub program: its very name if no other function has it. */
  String function(String subProgram) {
    return functions.computeIfAbsent(subProgram, this::newFunction);
  }

  private String newFunction(String wanted) {
    String name = wanted.strip();
    if (LEGAL.matcher(name).matches()
        && !KEYWORDS.contains(name)
        && !BUILTINS.contains(name)
        && !functions.containsValue(name)) {
      taken.add(name);
      return name;
    }
    return unique(name, "Subprogram");
  }

  /**
   * A name that nothing else has: the wanted one if possible.
   *
   * @param fallback when nothing of {@code wanted} can be used
   */
  String unique(String wanted, String fallback) {
    String stem = TreeNames.word(wanted, fallback);
    String name = stem;
    for (int i = 2; isTaken(name); i++) {
      name = stem + "_" + i;
    }
    add(name);
    return name;
  }

  /**
   * The variable with the handle of a thread: the wanted one, also where people have typed it to
   * stop the thread, unless another thread has it.
   */
  String handle(String wanted) {
    String name = handles.add(wanted) ? variable(wanted) : unique(wanted, "threadId");
    handles.add(name);
    made.add(name);
    return name;
  }

  /** The next of names that are counted from 1, as {@code Loop_1}. */
  String numbered(String stem) {
    while (true) {
      String name = stem + "_" + counts.merge(stem, 1, Integer::sum);
      if (!isTaken(name)) {
        add(name);
        return name;
      }
    }
  }

  private void add(String name) {
    taken.add(name);
    made.add(name);
  }

  private boolean isTaken(String name) {
    return taken.contains(name) || KEYWORDS.contains(name) || BUILTINS.contains(name);
  }
}
