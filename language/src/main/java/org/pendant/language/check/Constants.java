package org.pendant.language.check;

import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.BoolLiteral;
import org.pendant.language.syntax.Expression.FloatLiteral;
import org.pendant.language.syntax.Expression.IntLiteral;
import org.pendant.language.syntax.Expression.Unary;
import org.pendant.language.syntax.Expression.UnaryOperator;

/** Constant conditions, whose truth the text alone decides. */
final class Constants {
  private Constants() {}

  static boolean alwaysTrue(Expression condition) {
    return always(condition, true);
  }

  private static boolean always(Expression condition, boolean truth) {
    return switch (condition) {
      case BoolLiteral literal -> literal.value() == truth;
      case IntLiteral literal -> (literal.value() != 0) == truth;
      case FloatLiteral literal -> (literal.value() != 0) == truth;
      case Unary unary when unary.operator() == UnaryOperator.NOT ->
          always(unary.operand(), !truth);
      case Binary binary when binary.operator() == BinaryOperator.AND ->
          truth
              ? always(binary.left(), true) && always(binary.right(), true)
              : always(binary.left(), false) || always(binary.right(), false);
      case Binary binary when binary.operator() == BinaryOperator.OR ->
          truth
              ? always(binary.left(), true) || always(binary.right(), true)
              : always(binary.left(), false) && always(binary.right(), false);
      case Binary binary when binary.operator() == BinaryOperator.EQUAL ->
          bothBool(binary)
              && (always(binary.left(), true) == always(binary.right(), true)) == truth;
      default -> false;
    };
  }

  private static boolean bothBool(Binary binary) {
    return binary.left() instanceof BoolLiteral && binary.right() instanceof BoolLiteral;
  }
}
