package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.check.Binding;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.MethodCall;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Expression.Run;
import org.pendant.language.syntax.Expression.Unary;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;

/**
 * Expression compiler: compiles the expressions of one function. A value that already has a slot (a
 * variable, a constant) is used where it stands; everything else goes to temporaries.
 */
final class ExpressionCompiler {
  private final FunctionContext context;
  private final CodeBuilder code;
  private final ConditionCompiler conditions;
  private final CallCompiler calls;

  ExpressionCompiler(FunctionContext context, Builtins<?> builtins) {
    this.context = context;
    this.code = context.code();
    this.conditions = new ConditionCompiler(context, this);
    this.calls = new CallCompiler(context, this, builtins);
  }

  ConditionCompiler conditions() {
    return conditions;
  }

  /** Evaluates for the effect alone. */
  void effect(Expression expression) {
    int mark = context.mark();
    operand(expression);
    context.release(mark);
  }

  void handle(int operation, Expression expression) {
    int mark = context.mark();
    int operand = operand(expression);
    code.emit(operation, operand, 0, 0);
    context.release(mark);
  }

  void giveBack(Expression value) {
    int mark = context.mark();
    int operand =
        value instanceof Name name && context.binding(name) instanceof Binding.Local
            ? operand(value)
            : owned(value);
    code.at(value.range());
    code.emit(Op.RETURN, operand, 0, 0);
    context.release(mark);
  }

  /** Compiles {@code expression} and answers the operand of the slot that holds its value. */
  int operand(Expression expression) {
    Optional<Value> constant = ConstantValues.of(expression);
    if (constant.isPresent()) {
      return context.constant(constant.get());
    }
    if (expression instanceof Name name) {
      return context.variable(context.binding(name));
    }
    int target = context.temporary();
    int mark = context.mark();
    into(expression, target);
    context.release(mark);
    return Instruction.local(target);
  }

  /** As {@link #operand}, in a slot that no other code uses: a container is copied if it must. */
  int owned(Expression expression) {
    int operand = operand(expression);
    if (fresh(expression)) {
      return operand;
    }
    int copy = Instruction.local(context.temporary());
    code.at(expression.range());
    code.emit(Op.COPY, copy, operand, 0);
    return copy;
  }

  /** Whether the value of {@code expression} is new, so that it may be stored without a copy. */
  static boolean fresh(Expression expression) {
    return switch (expression) {
      case Name name -> false;
      case Index index -> false;
      case Member member -> false;
      case Expression.ListLiteral list -> ConstantValues.of(list).isEmpty();
      default -> true;
    };
  }

  /**
   * The operand of a left side that is read only after the right side was evaluated: a variable
   * that the right side could change meanwhile is moved to a temporary first.
   */
  int stable(Expression left, Expression right) {
    int operand = operand(left);
    if (left instanceof Name && ConstantValues.callsSomething(right)) {
      int copy = Instruction.local(context.temporary());
      code.at(left.range());
      code.emit(Op.MOVE, copy, operand, 0);
      return copy;
    }
    return operand;
  }

  /** Compiles {@code expression} so that its value stands in temporary {@code target}. */
  void into(Expression expression, int target) {
    int local = Instruction.local(target);
    switch (expression) {
      case Binary binary when OperatorGroups.isArithmetic(binary.operator()) ->
          arithmetic(binary, local);
      case Binary binary when OperatorGroups.isComparison(binary.operator()) ->
          comparison(binary, local);
      case Binary binary when binary.operator() == BinaryOperator.XOR -> {
        int left = stable(binary.left(), binary.right());
        int right = operand(binary.right());
        code.at(binary.range());
        code.emit(Op.XOR, local, left, right);
      }
      case Binary binary -> truth(binary, local);
      case Unary unary -> unary(unary, local);
      case Call call when call.function().equals("struct") -> calls.struct(call, local);
      case Call call -> calls.call(call, local);
      case MethodCall call -> calls.methodCall(call, local);
      case Index index -> getPart(index, local);
      case Member member -> getPart(member, local);
      case Run run -> {
        int thread =
            context.linkage().function(context.scope().function(run.thread()).orElseThrow());
        code.at(run.range());
        code.emit(Op.RUN, local, thread, 0);
      }
      case Expression.ListLiteral list -> {
        int first = elements(list.elements());
        code.at(list.range());
        code.emit(Op.LIST, local, list.elements().size(), Instruction.local(first));
      }
      case Expression.PoseLiteral pose -> {
        int first = elements(pose.elements());
        code.at(pose.range());
        code.emit(Op.POSE, local, 0, Instruction.local(first));
      }
      default -> {
        int operand = operand(expression);
        code.at(expression.range());
        code.emit(Op.MOVE, local, operand, 0);
      }
    }
  }

  void arithmetic(Binary binary, int target) {
    int left = stable(binary.left(), binary.right());
    int right = operand(binary.right());
    int operation =
        switch (binary.operator()) {
          case ADD -> Op.ADD;
          case SUBTRACT -> Op.SUBTRACT;
          case MULTIPLY -> Op.MULTIPLY;
          case DIVIDE -> Op.DIVIDE;
          default -> Op.MODULO;
        };
    code.at(binary.range());
    code.emit(operation, target, left, right);
  }

  private void comparison(Binary binary, int target) {
    int left = stable(binary.left(), binary.right());
    int right = operand(binary.right());
    code.at(binary.range());
    switch (binary.operator()) {
      case EQUAL -> code.emit(Op.EQUAL, target, left, right);
      case NOT_EQUAL -> code.emit(Op.NOT_EQUAL, target, left, right);
      case LESS -> code.emit(Op.LESS, target, left, right);
      case LESS_OR_EQUAL -> code.emit(Op.LESS_OR_EQUAL, target, left, right);
      case GREATER -> code.emit(Op.LESS, target, right, left);
      default -> code.emit(Op.LESS_OR_EQUAL, target, right, left);
    }
  }

  /** The value of {@code and} or {@code or}, by jumps, so that the right side may be skipped. */
  private void truth(Binary binary, int target) {
    List<Integer> whenFalse = new ArrayList<>();
    conditions.condition(binary, false, whenFalse);
    code.at(binary.range());
    code.emit(Op.MOVE, target, context.constant(Value.of(true)), 0);
    int end = code.emitJump(Op.JUMP, 0);
    whenFalse.forEach(jump -> code.land(jump, code.size()));
    code.emit(Op.MOVE, target, context.constant(Value.of(false)), 0);
    code.land(end, code.size());
  }

  private void unary(Unary unary, int target) {
    int operand = operand(unary.operand());
    code.at(unary.range());
    switch (unary.operator()) {
      case NEGATE -> code.emit(Op.NEGATE, target, operand, 0);
      case NOT -> code.emit(Op.NOT, target, operand, 0);
      // plus refuses what cannot be negated: minus twice
      case PLUS -> {
        code.emit(Op.NEGATE, target, operand, 0);
        code.emit(Op.NEGATE, target, target, 0);
      }
    }
  }

  /** The operand of a part of a variable, not copied; {@code receiver} of an index or member. */
  int part(Expression expression, boolean changed) {
    if (expression instanceof Name name) {
      return context.variable(context.binding(name));
    }
    int operand = operand(expression);
    if (changed && ConstantValues.of(expression).isPresent()) {
      return owned(expression);
    }
    return operand;
  }

  private void getPart(Expression expression, int target) {
    switch (expression) {
      case Index index when index.indices().size() == 1 -> {
        int receiver = part(index.receiver(), false);
        int place = operand(index.indices().get(0));
        code.at(index.range());
        code.emit(Op.GET_INDEX, target, receiver, place);
      }
      case Index index -> {
        int receiver = part(index.receiver(), false);
        int pair = pair(index);
        code.at(index.range());
        code.emit(Op.GET_INDEX_2, target, receiver, Instruction.local(pair));
      }
      case Member member -> {
        int receiver = part(member.receiver(), false);
        code.at(member.range());
        code.emit(Op.GET_MEMBER, target, receiver, context.linkage().name(member.member()));
      }
      default -> throw new IllegalStateException("not a part: " + expression);
    }
  }

  int pair(Index index) {
    int pair = context.temporaries(2);
    into(index.indices().get(0), pair);
    into(index.indices().get(1), pair + 1);
    return pair;
  }

  /** Evaluates elements that a new container will own into consecutive temporaries. */
  int elements(List<Expression> elements) {
    int first = context.temporaries(elements.size());
    for (int i = 0; i < elements.size(); i++) {
      argument(elements.get(i), first + i, true);
    }
    return first;
  }

  void argument(Expression expression, int target, boolean copied) {
    int mark = context.mark();
    if (copied && !fresh(expression)) {
      int operand = operand(expression);
      code.at(expression.range());
      code.emit(Op.COPY, Instruction.local(target), operand, 0);
    } else if (expression instanceof Name || ConstantValues.of(expression).isPresent()) {
      int operand = operand(expression);
      code.at(expression.range());
      code.emit(Op.MOVE, Instruction.local(target), operand, 0);
    } else {
      into(expression, target);
    }
    context.release(mark);
  }
}
