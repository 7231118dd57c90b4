package org.pendant.project.program;

import java.util.OptionalDouble;

/** Flow node: decides which nodes run. */
public sealed interface FlowStep extends Step {

  /**
   * Runs its children if a condition holds.
   *
   * @param continuously whether the children end as soon as it holds no more
   */
  record If(String condition, boolean continuously) implements FlowStep {}

  /**
   * Follows an {@link If} or another one of its kind beside it.
   *
   * @param continuously whether the children end as soon as the condition holds no more
   */
  record ElseIf(String condition, boolean continuously) implements FlowStep {
    /** Whose condition is looked at once. */
    public ElseIf(String condition) {
      this(condition, false);
    }
  }

  /** Follows an {@link If} or {@link ElseIf} beside it. */
  record Else() implements FlowStep {}

  /** Runs its children again and again. */
  record Loop(LoopRule rule) implements FlowStep {}

  /** Runs the one among its children, {@link Case} and {@link DefaultCase}, that fits a value. */
  record Switch(String expression) implements FlowStep {}

  /** Runs for a value, a number as it was typed. */
  record Case(String value) implements FlowStep {
    /** The value; empty if it is no number. */
    public OptionalDouble number() {
      return PlainNumber.of(value);
    }
  }

  /** Runs when no case fits. */
  record DefaultCase() implements FlowStep {}
}
