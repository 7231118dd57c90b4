package org.pendant.language.check;

import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.UnaryOperator;

/** Operator types: which kinds the operators take and give (manual 3 and 5). */
final class OperatorTypes {
  private OperatorTypes() {}

  /** Whether {@code left operator right} certainly fails. */
  static boolean fails(BinaryOperator operator, StaticType left, StaticType right) {
    return switch (operator) {
      case OR, XOR, AND -> !left.condition() || !right.condition();
      case EQUAL, NOT_EQUAL -> false;
      case LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL, ADD -> oneIsText(left, right);
      case SUBTRACT, MULTIPLY, DIVIDE, MODULO ->
          left == StaticType.STRING || right == StaticType.STRING;
    };
  }

  /** Whether {@code operator operand} certainly fails. */
  static boolean fails(UnaryOperator operator, StaticType operand) {
    return switch (operator) {
      case NOT -> !operand.condition();
      case NEGATE, PLUS -> operand == StaticType.STRING;
    };
  }

  static StaticType result(UnaryOperator operator, StaticType operand) {
    return switch (operator) {
      case NOT -> StaticType.BOOL;
      case NEGATE, PLUS ->
          switch (operand) {
            case NUMBER, LIST, MATRIX -> operand;
            case ANY, BOOL, STRING, POSE, STRUCT -> StaticType.ANY;
          };
    };
  }

  /** What {@code left operator right} gives where it does not fail. */
  static StaticType result(BinaryOperator operator, StaticType left, StaticType right) {
    return switch (operator) {
      case OR, XOR, AND, EQUAL, NOT_EQUAL, LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL ->
          StaticType.BOOL;
      case ADD ->
          left == StaticType.STRING || right == StaticType.STRING
              ? StaticType.STRING
              : sum(left, right);
      case SUBTRACT, DIVIDE, MODULO -> sum(left, right);
      case MULTIPLY ->
          left == StaticType.MATRIX && right == StaticType.LIST
              ? StaticType.LIST
              : sum(left, right);
    };
  }

  private static StaticType sum(StaticType left, StaticType right) {
    if (left == right) {
      return left == StaticType.NUMBER || left == StaticType.LIST || left == StaticType.MATRIX
          ? left
          : StaticType.ANY;
    }
    if (left == StaticType.NUMBER && (right == StaticType.LIST || right == StaticType.MATRIX)) {
      return right;
    }
    if (right == StaticType.NUMBER && (left == StaticType.LIST || left == StaticType.MATRIX)) {
      return left;
    }
    return StaticType.ANY;
  }

  private static boolean oneIsText(StaticType left, StaticType right) {
    return left.certain()
        && right.certain()
        && (left == StaticType.STRING) != (right == StaticType.STRING);
  }
}
