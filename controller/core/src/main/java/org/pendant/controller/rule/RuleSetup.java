package org.pendant.controller.rule;

import org.pendant.controller.wire.CellSignal;
import org.pendant.models.json.Range;

/**
 * Rule of a cell, as its file has it.
 *
 * @param trigger what it begins by
 * @param afterS how much later it acts, s
 * @param action what it does
 * @param forS after which time it does the opposite, s; 0 for never
 */
public record RuleSetup(Trigger trigger, double afterS, Action action, double forS) {
  /** Times of rules. */
  static final Range TIME = new Range(0, 3600, "s");

  /** How often something repeats. */
  static final Range PERIOD = new Range(0.01, 3600, "s");

  /** What a rule begins by. */
  public sealed interface Trigger {
    /** Each time a condition becomes true. */
    record When(SignalCondition condition) implements Trigger {}

    /** As long as a condition holds, and the opposite as long as it does not. */
    record While(SignalCondition condition) implements Trigger {}

    /** Again and again. */
    record Every(double periodS) implements Trigger {}
  }

  /** What a rule does. */
  public sealed interface Action {
    /**
     * Sets a signal.
     *
     * @param value to which
     * @param opposite its value after that: the other level, and 0 for numbers
     */
    record Set(CellSignal signal, int value, int opposite) implements Action {}

    /**
     * Puts a part between the fingers of a gripper; the opposite takes it away.
     *
     * @param widthM 0 for no part
     */
    record PutPart(String gripper, double widthM) implements Action {}

    /** Presses a switch; the opposite lets go of it. */
    record Press(String device) implements Action {}
  }
}
