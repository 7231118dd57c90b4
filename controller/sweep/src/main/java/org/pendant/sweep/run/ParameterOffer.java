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
    VARIABLES("groupVariable"),
    /** All moves, and each of them. */
    MOVES("groupMoves"),
    /** What hangs on the flange. */
    LOAD("groupLoad"),
    /** Where the base stands. */
    BASE("groupBase"),
    /** Features of the installation. */
    FEATURES("groupFeature"),
    /** Objects of the scene. */
    OBJECTS("groupObject"),
    /** Inputs that the program reads. */
    INPUTS("groupInput"),
    /** The arm, its noise, the slider. */
    ROBOT("groupRobot");

    private final String key;

    Group(String key) {
      this.key = key;
    }

    /** For people. */
    public String title() {
      return SweepRunTexts.text(key);
    }
  }
}
