package org.pendant.project.program;

import java.util.List;

/**
 * Section: a part of a program as a whole; such nodes stand at the top of the tree and nowhere
 * else.
 */
public sealed interface Section extends Step {

  /** Values that variables have before anything else runs; has no children. At most one. */
  record InitialValues(List<InitialValue> values) implements Section {
    public InitialValues {
      values = List.copyOf(values);
    }
  }

  /**
   * The first value of a variable.
   *
   * @param expression computed when the program starts
   */
  record InitialValue(String variable, String expression) {}

  /** Runs once before the main program. At most one. */
  record BeforeStart() implements Section {}

  /**
   * The main program; every tree has exactly one.
   *
   * @param forever whether it begins again at its end
   */
  record MainProgram(boolean forever) implements Section {}

  /**
   * Runs beside the main program.
   *
   * @param name what people call it; need not be a name of the language
   * @param forever whether it begins again at its end
   */
  record ThreadSection(String name, boolean forever) implements Section {}

  /**
   * Its children run once each time when a condition comes to hold, beside the main program.
   *
   * @param condition an expression for true or false
   */
  record Event(String condition) implements Section {}

  /**
   * A part of a program that is called by {@link ActionStep.Call}.
   *
   * @param name what calls name
   * @param file whose program it is a copy of, relative to this program's; empty when it stands
   *     only here
   */
  record SubProgram(String name, String file) implements Section {}
}
