package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.Unary;
import org.pendant.language.syntax.Expression.UnaryOperator;

/**
 * Condition compiler: compiles conditions to jumps, so that the right side of {@code and} and
 * {@code or} is skipped.
 */
final class ConditionCompiler {
  private final FunctionContext context;
  private final CodeBuilder code;
  private final ExpressionCompiler expressions;
  private final CoveragePoints coverage;

  ConditionCompiler(FunctionContext context, ExpressionCompiler expressions) {
    this.context = context;
    this.code = context.code();
    this.expressions = expressions;
    coverage = context.coverage();
  }

  /** Jumps when the truth of {@code expression} is {@code when}; {@code jumps} collects them. */
  void condition(Expression expression, boolean when, List<Integer> jumps) {
    switch (expression) {
      case Expression.BoolLiteral literal -> {
        if (literal.value() == when) {
          jumps.add(code.emitJump(Op.JUMP, 0));
        }
      }
      case Unary unary when unary.operator() == UnaryOperator.NOT ->
          condition(unary.operand(), !when, jumps);
      case Binary binary when binary.operator() == BinaryOperator.AND ->
          both(binary, when, false, jumps);
      case Binary binary when binary.operator() == BinaryOperator.OR ->
          both(binary, when, true, jumps);
      case Binary binary when OperatorGroups.isComparison(binary.operator()) ->
          compare(binary, when, jumps);
      default -> {
        int mark = context.mark();
        int operand = expressions.operand(expression);
        code.at(expression.range());
        jumps.add(code.emitJump(when ? Op.JUMP_IF_TRUE : Op.JUMP_IF_FALSE, operand));
        context.release(mark);
      }
    }
  }

  /** {@code and} and {@code or}: the left side decides alone when it is {@code deciding}. */
  private void both(Binary binary, boolean when, boolean deciding, List<Integer> jumps) {
    if (when == deciding) {
      operand(binary.left(), when, jumps);
      operand(binary.right(), when, jumps);
    } else {
      List<Integer> decided = new ArrayList<>();
      operand(binary.left(), deciding, decided);
      operand(binary.right(), when, jumps);
      decided.forEach(jump -> code.land(jump, code.size()));
    }
  }

  /**
   * As {@link #condition}, of an operand of {@code and} or {@code or}. Where both ways are marked,
   * what jumps is the other one, so that either leads over its mark.
   */
  private void operand(Expression expression, boolean when, List<Integer> jumps) {
    if (!coverage.wanted() || isConstant(expression) || hasOperands(expression)) {
      condition(expression, when, jumps);
      return;
    }
    int decision = coverage.operand(expression.range());
    List<Integer> others = new ArrayList<>();
    condition(expression, !when, others);
    coverage.decided(decision, when);
    jumps.add(code.emitUnpaid(Instruction.jump(Op.JUMP, 0, 0)));
    others.forEach(jump -> code.land(jump, code.size()));
    coverage.decided(decision, !when);
  }

  /** Whether {@code expression} decides nothing: True or False stands there. */
  static boolean isConstant(Expression expression) {
    return switch (expression) {
      case Expression.BoolLiteral literal -> true;
      case Unary unary -> unary.operator() == UnaryOperator.NOT && isConstant(unary.operand());
      default -> false;
    };
  }

  /** Whether it is {@code and} or {@code or}, turned round or not. */
  private static boolean hasOperands(Expression expression) {
    return switch (expression) {
      case Unary unary -> unary.operator() == UnaryOperator.NOT && hasOperands(unary.operand());
      case Binary binary ->
          binary.operator() == BinaryOperator.AND || binary.operator() == BinaryOperator.OR;
      default -> false;
    };
  }

  private void compare(Binary binary, boolean when, List<Integer> jumps) {
    int mark = context.mark();
    int left = expressions.stable(binary.left(), binary.right());
    int right = expressions.operand(binary.right());
    code.at(binary.range());
    jumps.add(
        switch (binary.operator()) {
          case LESS -> code.emit(when ? Op.JUMP_IF_LESS : Op.JUMP_IF_NOT_LESS, left, right, 0);
          case LESS_OR_EQUAL ->
              code.emit(
                  when ? Op.JUMP_IF_LESS_OR_EQUAL : Op.JUMP_IF_NOT_LESS_OR_EQUAL, left, right, 0);
          case GREATER -> code.emit(when ? Op.JUMP_IF_LESS : Op.JUMP_IF_NOT_LESS, right, left, 0);
          case GREATER_OR_EQUAL ->
              code.emit(
                  when ? Op.JUMP_IF_LESS_OR_EQUAL : Op.JUMP_IF_NOT_LESS_OR_EQUAL, right, left, 0);
          case EQUAL -> code.emit(when ? Op.JUMP_IF_EQUAL : Op.JUMP_IF_NOT_EQUAL, left, right, 0);
          default -> code.emit(when ? Op.JUMP_IF_NOT_EQUAL : Op.JUMP_IF_EQUAL, left, right, 0);
        });
    context.release(mark);
  }

  /** Whether {@link #repeat} decides at the loop's end, without going back to its beginning. */
  static boolean repeatsInPlace(Expression condition) {
    return condition instanceof Binary binary && OperatorGroups.isOrder(binary.operator());
  }

  /**
   * The end of a loop: back to {@code body} when the condition still holds.
   *
   * @param decision the coverage of the condition
   * @return a jump of the other case, which falls through if there is none
   */
  OptionalInt repeat(Expression condition, int decision, int top, int body) {
    if (!repeatsInPlace(condition)) {
      code.land(code.emitJump(Op.LOOP, 0), top);
      return OptionalInt.empty();
    }
    Binary binary = (Binary) condition;
    boolean orEqual =
        binary.operator() == BinaryOperator.LESS_OR_EQUAL
            || binary.operator() == BinaryOperator.GREATER_OR_EQUAL;
    boolean turned =
        binary.operator() == BinaryOperator.GREATER
            || binary.operator() == BinaryOperator.GREATER_OR_EQUAL;
    int mark = context.mark();
    int left = expressions.stable(binary.left(), binary.right());
    int right = expressions.operand(binary.right());
    int first = turned ? right : left;
    int second = turned ? left : right;
    context.release(mark);
    if (!coverage.wanted()) {
      code.land(
          code.emit(orEqual ? Op.LOOP_IF_LESS_OR_EQUAL : Op.LOOP_IF_LESS, first, second, 0), body);
      return OptionalInt.empty();
    }
    int otherwise =
        code.emit(orEqual ? Op.JUMP_IF_NOT_LESS_OR_EQUAL : Op.JUMP_IF_NOT_LESS, first, second, 0);
    coverage.decided(decision, true);
    // together with the jump it stands for one instruction
    code.land(code.emitUnpaid(Instruction.jump(Op.LOOP, 0, 0)), body);
    return OptionalInt.of(otherwise);
  }
}
