package org.pendant.script.vm;

import org.pendant.language.syntax.Expression.BinaryOperator;

/** Operator groups: the groups that binary operators fall into. */
final class OperatorGroups {
  private OperatorGroups() {}

  static boolean isArithmetic(BinaryOperator operator) {
    return switch (operator) {
      case ADD, SUBTRACT, MULTIPLY, DIVIDE, MODULO -> true;
      default -> false;
    };
  }

  static boolean isOrder(BinaryOperator operator) {
    return switch (operator) {
      case LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL -> true;
      default -> false;
    };
  }

  static boolean isComparison(BinaryOperator operator) {
    return isOrder(operator)
        || operator == BinaryOperator.EQUAL
        || operator == BinaryOperator.NOT_EQUAL;
  }
}
