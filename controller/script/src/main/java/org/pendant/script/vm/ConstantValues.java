package org.pendant.script.vm;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.language.syntax.Expression;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.MatrixValue;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Constant values: known from the text alone. */
final class ConstantValues {
  private ConstantValues() {}

  /** The value of a literal, a signed number, or a pose or number list of such. */
  static Optional<Value> of(Expression expression) {
    return switch (expression) {
      case Expression.IntLiteral literal -> Optional.of(Value.of(literal.value()));
      case Expression.FloatLiteral literal -> Optional.of(Value.of(literal.value()));
      case Expression.BoolLiteral literal -> Optional.of(Value.of(literal.value()));
      case Expression.StringLiteral literal -> Optional.of(Value.of(literal.value()));
      case Expression.NoneLiteral literal -> Optional.of(NoneValue.NONE);
      case Expression.Unary unary when unary.operator() == Expression.UnaryOperator.NEGATE ->
          switch (unary.operand()) {
            case Expression.IntLiteral literal when literal.value() != Integer.MIN_VALUE ->
                Optional.of(Value.of(-literal.value()));
            case Expression.FloatLiteral literal -> Optional.of(Value.of(-literal.value()));
            default -> Optional.empty();
          };
      case Expression.PoseLiteral pose -> numbers(pose.elements()).map(ConstantValues::pose);
      case Expression.ListLiteral list
          when !list.elements().isEmpty()
              && list.elements().getFirst() instanceof Expression.ListLiteral ->
          matrix(list);
      case Expression.ListLiteral list when !list.elements().isEmpty() ->
          numbers(list.elements())
              .map(
                  numbers ->
                      NumberList.owning(
                          numbers,
                          numbers.length,
                          list.elements().stream().allMatch(ConstantValues::isInt)
                              ? ValueKind.INT
                              : ValueKind.FLOAT));
      default -> Optional.empty();
    };
  }

  /** A matrix whose rows are all known and of one length. */
  private static Optional<Value> matrix(Expression.ListLiteral rows) {
    int columns = -1;
    boolean integers = true;
    double[] elements = {};
    for (int row = 0; row < rows.elements().size(); row++) {
      if (!(rows.elements().get(row) instanceof Expression.ListLiteral list)) {
        return Optional.empty();
      }
      Optional<double[]> numbers = numbers(list.elements());
      if (numbers.isEmpty()
          || numbers.get().length == 0
          || (row > 0 && numbers.get().length != columns)) {
        return Optional.empty();
      }
      columns = numbers.get().length;
      elements = Arrays.copyOf(elements, (row + 1) * columns);
      System.arraycopy(numbers.get(), 0, elements, row * columns, columns);
      integers &= list.elements().stream().allMatch(ConstantValues::isInt);
    }
    return Optional.of(MatrixValue.owning(rows.elements().size(), columns, elements, integers));
  }

  private static Value pose(double[] n) {
    return new PoseValue(new Pose(n[0], n[1], n[2], n[3], n[4], n[5]));
  }

  private static Optional<double[]> numbers(List<Expression> elements) {
    double[] numbers = new double[elements.size()];
    for (int i = 0; i < numbers.length; i++) {
      Optional<Value> element = scalar(elements.get(i));
      if (element.isEmpty()) {
        return Optional.empty();
      }
      switch (element.get()) {
        case IntValue value -> numbers[i] = value.value();
        case FloatValue value -> numbers[i] = value.value();
        default -> {
          return Optional.empty();
        }
      }
    }
    return Optional.of(numbers);
  }

  private static Optional<Value> scalar(Expression expression) {
    return switch (expression) {
      case Expression.ListLiteral list -> Optional.empty();
      case Expression.PoseLiteral pose -> Optional.empty();
      default -> of(expression);
    };
  }

  private static boolean isInt(Expression expression) {
    return of(expression).filter(value -> value.kind() == ValueKind.INT).isPresent();
  }

  /** Whether evaluating {@code expression} could change a variable. */
  static boolean callsSomething(Expression expression) {
    return switch (expression) {
      case Expression.Call call -> true;
      case Expression.MethodCall call -> true;
      case Expression.Binary binary ->
          callsSomething(binary.left()) || callsSomething(binary.right());
      case Expression.Unary unary -> callsSomething(unary.operand());
      case Expression.Index index ->
          callsSomething(index.receiver())
              || index.indices().stream().anyMatch(ConstantValues::callsSomething);
      case Expression.Member member -> callsSomething(member.receiver());
      case Expression.ListLiteral list ->
          list.elements().stream().anyMatch(ConstantValues::callsSomething);
      case Expression.PoseLiteral pose ->
          pose.elements().stream().anyMatch(ConstantValues::callsSomething);
      default -> false;
    };
  }
}
