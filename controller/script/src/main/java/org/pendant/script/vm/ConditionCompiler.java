package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
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

  ConditionCompiler(FunctionContext context, ExpressionCompiler expressions) {
    this.context = context;
    this.code = context.code();
    this.expressions = expressions;
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
      condition(binary.left(), when, jumps);
      condition(binary.right(), when, jumps);
    } else {
      List<Integer> decided = new ArrayList<>();
      condition(binary.left(), deciding, decided);
      condition(binary.right(), when, jumps);
      decided.forEach(jump -> code.land(jump, code.size()));
    }
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

  /** The end of a loop: back to {@code body} when the condition still holds. */
  void repeat(Expression condition, int top, int body) {
    int mark = context.mark();
    if (condition instanceof Binary binary && OperatorGroups.isOrder(binary.operator())) {
      int left = expressions.stable(binary.left(), binary.right());
      int right = expressions.operand(binary.right());
      int jump =
          switch (binary.operator()) {
            case LESS -> code.emit(Op.LOOP_IF_LESS, left, right, 0);
            case LESS_OR_EQUAL -> code.emit(Op.LOOP_IF_LESS_OR_EQUAL, left, right, 0);
            case GREATER -> code.emit(Op.LOOP_IF_LESS, right, left, 0);
            default -> code.emit(Op.LOOP_IF_LESS_OR_EQUAL, right, left, 0);
          };
      code.land(jump, body);
    } else {
      code.land(code.emitJump(Op.LOOP, 0), top);
    }
    context.release(mark);
  }
}
