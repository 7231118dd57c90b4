package org.pendant.project.program;

import java.util.OptionalDouble;

/** Loop rule: how long a {@link FlowStep.Loop} continues. */
public sealed interface LoopRule {

  /** For ever. */
  record Forever() implements LoopRule {}

  /**
   * So many times.
   *
   * @param count an expression, computed in each turn
   * @param variable that counts the turns from 0; empty for one with a name of its own
   */
  record Times(String count, String variable) implements LoopRule {
    /** How often, if that is a number and nothing to compute. */
    public OptionalDouble number() {
      return PlainNumber.of(count);
    }
  }

  /**
   * While a condition holds.
   *
   * @param continuously whether the children end as soon as it holds no more
   */
  record While(String condition, boolean continuously) implements LoopRule {}
}
