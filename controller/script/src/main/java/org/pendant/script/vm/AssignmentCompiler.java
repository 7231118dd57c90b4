package org.pendant.script.vm;

import java.util.List;
import java.util.Optional;
import org.pendant.language.check.OutputAssignment;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Binary;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Index;
import org.pendant.language.syntax.Expression.Member;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement;

/** Assignment compiler: compiles assignments to variables and to parts of them. */
final class AssignmentCompiler {
  private final FunctionContext context;
  private final CodeBuilder code;
  private final ExpressionCompiler expressions;
  private final PartCompiler parts;

  AssignmentCompiler(FunctionContext context, ExpressionCompiler expressions) {
    this.context = context;
    this.code = context.code();
    this.expressions = expressions;
    parts = new PartCompiler(context, expressions);
  }

  /** Gives {@code variable} its first value. */
  void initialise(int variable, Expression value) {
    int mark = context.mark();
    int operand = expressions.operand(value);
    code.at(value.range());
    code.emit(ExpressionCompiler.fresh(value) ? Op.ASSIGN : Op.ASSIGN_COPY, variable, operand, 0);
    context.release(mark);
  }

  void assign(Statement.Assign assign) {
    Optional<Call> output = OutputAssignment.call(assign, context.scope());
    if (output.isPresent()) {
      expressions.effect(output.get());
      return;
    }
    int mark = context.mark();
    switch (assign.target()) {
      case Name name -> assignVariable(assign, context.variable(context.target(assign)));
      case Index index -> setIndex(assign, index, expressions.owned(assign.value()));
      case Member member -> setMember(assign, member, expressions.owned(assign.value()));
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

  private void setIndex(Statement.Assign assign, Index target, int value) {
    PartCompiler.Part container = container(assign, target.receiver(), target.indices());
    if (target.indices().size() == 1) {
      int index = expressions.operand(target.indices().get(0));
      PartCompiler.Opened opened = parts.open(container);
      code.at(assign.range());
      code.emit(Op.SET_INDEX, opened.operand(), index, value);
      parts.putBack(container, opened);
    } else {
      int pair = expressions.pair(target);
      PartCompiler.Opened opened = parts.open(container);
      code.at(assign.range());
      code.emit(Op.SET_INDEX_2, opened.operand(), Instruction.local(pair), value);
    }
  }

  private void setMember(Statement.Assign assign, Member target, int value) {
    PartCompiler.Part container = container(assign, target.receiver(), List.of());
    PartCompiler.Opened opened = parts.open(container);
    code.at(assign.range());
    code.emit(Op.SET_MEMBER, opened.operand(), context.linkage().name(target.member()), value);
  }

  /** The container that an assignment changes: a variable, or a part of one. */
  private PartCompiler.Part container(
      Statement.Assign assign, Expression container, List<Expression> indices) {
    return parts.part(container, context.variable(context.target(assign)), indices);
  }
}
