package org.pendant.language.check;

import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.UnaryOperator;

/** Which kinds the operators take and give (manual 3 and 5). */
final class Operators {
  private Operators() {}

  /** Whether {@code left operator right} certainly fails. */
  static boolean fails(BinaryOperator operator, Kind left, Kind right) {
    return switch (operator) {
      case OR, XOR, AND -> !left.condition() || !right.condition();
      case EQUAL, NOT_EQUAL -> false;
      case LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL, ADD -> oneIsText(left, right);
      case SUBTRACT, MULTIPLY, DIVIDE, MODULO -> left == Kind.STRING || right == Kind.STRING;
    };
  }

  /** Whether {@code operator operand} certainly fails. */
  static boolean fails(UnaryOperator operator, Kind operand) {
    return switch (operator) {
      case NOT -> !operand.condition();
      case NEGATE, PLUS -> operand == Kind.STRING;
    };
  }

  static Kind result(UnaryOperator operator, Kind operand) {
    return switch (operator) {
      case NOT -> Kind.BOOL;
      case NEGATE, PLUS ->
          switch (operand) {
            case NUMBER, LIST, MATRIX -> operand;
            case ANY, BOOL, STRING, POSE, STRUCT -> Kind.ANY;
          };
    };
  }

  /** What {@code left operator right} gives where it does not fail. */
  static Kind result(BinaryOperator operator, Kind left, Kind right) {
    return switch (operator) {
      case OR, XOR, AND, EQUAL, NOT_EQUAL, LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL ->
          Kind.BOOL;
      case ADD -> left == Kind.STRING || right == Kind.STRING ? Kind.STRING : sum(left, right);
      case SUBTRACT, DIVIDE, MODULO -> sum(left, right);
      case MULTIPLY -> left == Kind.MATRIX && right == Kind.LIST ? Kind.LIST : sum(left, right);
    };
  }

  private static Kind sum(Kind left, Kind right) {
    if (left == right) {
      return left == Kind.NUMBER || left == Kind.LIST || left == Kind.MATRIX ? left : Kind.ANY;
    }
    if (left == Kind.NUMBER && (right == Kind.LIST || right == Kind.MATRIX)) {
      return right;
    }
    if (right == Kind.NUMBER && (left == Kind.LIST || left == Kind.MATRIX)) {
      return left;
    }
    return Kind.ANY;
  }

  private static boolean oneIsText(Kind left, Kind right) {
    return left.certain() && right.certain() && (left == Kind.STRING) != (right == Kind.STRING);
  }
}
