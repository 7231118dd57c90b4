package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.UnaryOperator;

/** Operator table: what each operator token means and how tightly it binds (manual 3, 5). */
final class OperatorTable {
  /** {@code not} negates a whole comparison. */
  static final int PRECEDENCE_OF_NOT = 3;

  static final int PRECEDENCE_OF_SIGN = 7;

  private OperatorTable() {}

  /** How tightly an operator between two operands binds; looser ones have smaller numbers. */
  static int precedence(int type) {
    return switch (type) {
      case OR, XOR -> 1;
      case AND -> 2;
      case EQUAL, NOT_EQUAL, LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL -> 4;
      case PLUS, MINUS -> 5;
      case STAR, SLASH, PERCENT -> 6;
      default -> throw new IllegalStateException("not an operator: token type " + type);
    };
  }

  static BinaryOperator operator(int type) {
    return switch (type) {
      case OR -> BinaryOperator.OR;
      case XOR -> BinaryOperator.XOR;
      case AND -> BinaryOperator.AND;
      case EQUAL -> BinaryOperator.EQUAL;
      case NOT_EQUAL -> BinaryOperator.NOT_EQUAL;
      case LESS -> BinaryOperator.LESS;
      case GREATER -> BinaryOperator.GREATER;
      case LESS_OR_EQUAL -> BinaryOperator.LESS_OR_EQUAL;
      case GREATER_OR_EQUAL -> BinaryOperator.GREATER_OR_EQUAL;
      case PLUS -> BinaryOperator.ADD;
      case MINUS -> BinaryOperator.SUBTRACT;
      case STAR -> BinaryOperator.MULTIPLY;
      case SLASH -> BinaryOperator.DIVIDE;
      default -> BinaryOperator.MODULO;
    };
  }

  static UnaryOperator unary(int type) {
    return switch (type) {
      case NOT, BANG -> UnaryOperator.NOT;
      case PLUS, LINE_PLUS -> UnaryOperator.PLUS;
      default -> UnaryOperator.NEGATE;
    };
  }
}
