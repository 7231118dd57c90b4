package org.pendant.controller.machine;

import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement;

/** Compiles assignments to variables and to parts of them. */
final class AssignmentCompiler {
  private final FunctionContext context;
  private final CodeBuilder code;
  private final ExpressionCompiler expressions;

  AssignmentCompiler(FunctionContext context, ExpressionCompiler expressions) {
    this.context = context;
    this.code = context.code();
    this.expressions = expressions;
  }

  void assignGlobal(String name, Expression value) {
    int mark = context.mark();
    int operand = expressions.operand(value);
    code.emit(
        ExpressionCompiler.fresh(value) ? Op.ASSIGN : Op.ASSIGN_COPY,
        context.linkage().statics().global(name),
        operand,
        0);
    context.release(mark);
  }

  void assign(Statement.Assign assign) {
    int mark = context.mark();
    switch (assign.target()) {
      case Name name -> assignVariable(assign, context.variable(context.target(assign)));
      case Index index -> {
        int value = expressions.owned(assign.value());
        setIndex(assign, index, value);
      }
      case Member member -> {
        int value = expressions.owned(assign.value());
        setMember(assign, member, value);
      }
      default ->
          throw new IllegalStateException(
              "cannot assign to " + context.source().text(assign.range()));
    }
    context.release(mark);
  }

  private void assignVariable(Statement.Assign assign, int target) {
    Expression value = assign.value();
    switch (value) {
      case Binary binary when OperatorGroups.isArithmetic(binary.operator()) ->
          expressions.arithmetic(binary, target);
      case Index index when index.indices().size() == 1 -> {
        // an element that is not a number must be copied out of its container
        int element = expressions.operand(value);
        code.at(assign.range());
        code.emit(Op.ASSIGN_COPY, target, element, 0);
      }
      default -> {
        int operand = expressions.operand(value);
        code.at(assign.range());
        code.emit(ExpressionCompiler.fresh(value) ? Op.ASSIGN : Op.ASSIGN_COPY, target, operand, 0);
      }
    }
  }

  /** Stores into {@code target[...]}, and the changed container back into its own container. */
  private void setIndex(Statement.Assign assign, Index target, int value) {
    int container = place(assign, target.receiver());
    if (target.indices().size() == 1) {
      int index = expressions.operand(target.indices().get(0));
      code.at(assign.range());
      code.emit(Op.SET_INDEX, container, index, value);
    } else {
      int pair = expressions.pair(target);
      code.at(assign.range());
      code.emit(Op.SET_INDEX_2, container, Instruction.local(pair), value);
    }
    putBack(assign, target.receiver(), container);
  }

  private void setMember(Statement.Assign assign, Member target, int value) {
    int container = place(assign, target.receiver());
    code.at(assign.range());
    code.emit(Op.SET_MEMBER, container, context.linkage().name(target.member()), value);
    putBack(assign, target.receiver(), container);
  }

  /** The operand of the container that an assignment changes: a variable, or a part of one. */
  private int place(Statement.Assign assign, Expression container) {
    return container instanceof Name
        ? context.variable(context.target(assign))
        : expressions.part(container, true);
  }

  /** A pose is replaced, not changed, so what holds it takes the new one. */
  private void putBack(Statement.Assign assign, Expression container, int value) {
    switch (container) {
      case Index index -> setIndex(assign, index, value);
      case Member member -> setMember(assign, member, value);
      default -> {}
    }
  }
}
