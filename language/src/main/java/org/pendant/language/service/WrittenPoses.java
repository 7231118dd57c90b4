package org.pendant.language.service;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.UnaryOperator;
import org.pendant.language.syntax.Node;
import org.pendant.language.syntax.Script;

/** Written poses: finds the poses whose six elements are numbers. */
final class WrittenPoses {
  private WrittenPoses() {}

  static List<WrittenPose> of(Script script) {
    List<WrittenPose> found = new ArrayList<>();
    visit(script, found);
    return List.copyOf(found);
  }

  private static void visit(Node node, List<WrittenPose> found) {
    if (node instanceof Expression.PoseLiteral pose) {
      List<Double> numbers =
          pose.elements().stream()
              .map(WrittenPoses::number)
              .filter(OptionalDouble::isPresent)
              .map(OptionalDouble::getAsDouble)
              .toList();
      if (numbers.size() == 6 && pose.elements().size() == 6) {
        found.add(new WrittenPose(pose.range(), numbers));
      }
    }
    node.children().forEach(child -> visit(child, found));
  }

  private static OptionalDouble number(Expression expression) {
    return switch (expression) {
      case Expression.IntLiteral literal -> OptionalDouble.of(literal.value());
      case Expression.FloatLiteral literal -> OptionalDouble.of(literal.value());
      case Expression.Unary unary when unary.operator() == UnaryOperator.PLUS ->
          number(unary.operand());
      case Expression.Unary unary when unary.operator() == UnaryOperator.NEGATE -> {
        OptionalDouble operand = number(unary.operand());
        yield operand.isPresent() ? OptionalDouble.of(-operand.getAsDouble()) : operand;
      }
      default -> OptionalDouble.empty();
    };
  }
}
