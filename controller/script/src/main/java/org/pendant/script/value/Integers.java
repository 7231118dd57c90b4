package org.pendant.script.value;

import org.pendant.language.syntax.Expression.BinaryOperator;

/** Integer results: checks results that have to be ints. */
final class Integers {
  private Integers() {}

  /** Refuses what does not fit an int, and makes a negative zero an ordinary one. */
  static void check(BinaryOperator operator, double[] numbers, int from, int to)
      throws ScriptError {
    for (int i = from; i < to; i++) {
      int integer = (int) numbers[i];
      if (integer != numbers[i]) {
        throw Operators.integerOverflow(operator.text(), numbers[i]);
      }
      numbers[i] = integer;
    }
  }
}
