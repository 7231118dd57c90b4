package org.pendant.sweep.run;

import org.pendant.sweep.plan.ParameterTarget;

/**
 * Parameter offer: something of a program, its robot or its cell that a plan could vary.
 *
 * @param group what it belongs to, for people
 * @param target what would be changed
 * @param now what it is without a plan, as people read it; empty where that means nothing
 * @param unit of its numbers; empty for none
 * @param from a sensible least value; as {@code to} empty where it has no numbers
 * @param to a sensible largest value
 * @param values sensible values as a list; empty where a range is more sensible
 */
public record ParameterOffer(
    Group group,
    ParameterTarget target,
    String now,
    String unit,
    String from,
    String to,
    String values) {

  /** What an offer belongs to, in the order in which people look for it. */
  public enum Group {
    /** Variables of the script, and defaults of parameters. */
    VARIABLES("Variable"),
    /** All moves, and each of them. */
    MOVES("Moves"),
    /** What hangs on the flange. */
    LOAD("Load"),
    /** Where the base stands. */
    BASE("Base"),
    /** Features of the installation. */
    FEATURES("Feature"),
    /** Objects of the scene. */
    OBJECTS("Object"),
    /** Inputs that the program reads. */
    INPUTS("Input"),
    /** The arm, its noise, the slider. */
    ROBOT("Robot");

    private final String title;

    Group(String title) {
      this.title = title;
    }

    /** For people. */
    public String title() {
      return title;
    }
  }
}
