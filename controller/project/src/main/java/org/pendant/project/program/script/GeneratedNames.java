package org.pendant.project.program.script;

import java.util.Set;

/**
 * Generated names: what a generated script calls its program, and the variables that nobody has
 * given a name: poses and joint positions of waypoints, counters, handles of threads.
 *
 * @param program the name of its function
 * @param variables names of functions and threads that it makes are among them
 */
public record GeneratedNames(String program, Set<String> variables) {
  /** Those of a script that people have written. */
  public static final GeneratedNames NONE = new GeneratedNames("", Set.of());

  public GeneratedNames {
    variables = Set.copyOf(variables);
  }
}
