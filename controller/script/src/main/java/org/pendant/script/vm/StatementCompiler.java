package org.pendant.script.vm;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Node;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtins;

/** Statement compiler: compiles the statements of one function. */
final class StatementCompiler {
  /** Where leaving and repeating the innermost loops lead. */
  private record Loop(List<Integer> breaks, List<Integer> continues) {}

  private final FunctionContext context;
  private final ExpressionCompiler expressions;
  private final ConditionCompiler conditions;
  private final AssignmentCompiler assignments;
  private final CodeBuilder code;
  private final CoveragePoints coverage;
  private final Deque<Loop> loops = new ArrayDeque<>();

  StatementCompiler(FunctionContext context, Builtins<?> builtins) {
    this.context = context;
    code = context.code();
    coverage = context.coverage();
    expressions = new ExpressionCompiler(context, builtins);
    conditions = expressions.conditions();
    assignments = new AssignmentCompiler(context, expressions);
  }

  ScriptFunction finish(Definition definition) {
    return finish(
        definition.name(), Optional.of(definition.nameRange()), definition.parameters().size());
  }

  /**
   * Ends a function, thread or main level.
   *
   * @param nameRange where its name stands; empty for a main level without one
   */
  ScriptFunction finish(String name, Optional<SourceRange> nameRange, int parameterCount) {
    coverage.end(context.source(), name, nameRange);
    code.emit(Op.RETURN_NONE, 0, 0, 0);
    return context.function(name, parameterCount);
  }

  /** Ends an interpreted line, whose variables all stay as they are when it is entered. */
  ScriptFunction finishLine() {
    code.emit(Op.INTERPRETED, 0, 0, 0);
    return context.function("interpreter", 0);
  }

  /** Gives the global variable {@code name} its first value. */
  void initialise(String name, Expression value) {
    assignments.initialise(context.linkage().statics().global(name), value);
  }

  /** Gives parameters that a call has left out the values that only a call can find out. */
  void defaults(List<ParameterDeclaration> parameters) {
    for (int i = 0; i < parameters.size(); i++) {
      Optional<Expression> value = parameters.get(i).defaultValue();
      if (value.isPresent() && ConstantValues.of(value.get()).isEmpty()) {
        int parameter = Instruction.local(i);
        code.at(value.get().range());
        int given = code.emitJump(Op.JUMP_IF_GIVEN, parameter);
        assignments.initialise(parameter, value.get());
        code.land(given, code.size());
      }
    }
  }

  void statements(List<Statement> statements) {
    for (int i = 0; i < statements.size(); i++) {
      statement(statements.get(i), isImplied(statements, i));
    }
  }

  /** Whether statement {@code index} of a block is over when another one begins, and only then. */
  private static boolean isImplied(List<Statement> block, int index) {
    return switch (block.get(index)) {
      case Statement.Assign assign -> hasCode(block, index + 1);
      case Statement.Evaluate evaluate -> hasCode(block, index + 1);
      case Statement.Join join -> hasCode(block, index + 1);
      case Statement.Kill kill -> hasCode(block, index + 1);
      case Statement.Pause pause -> hasCode(block, index + 1);
      case Statement.EnterCritical enter -> hasCode(block, index + 1);
      case Statement.ExitCritical exit -> hasCode(block, index + 1);
      default -> false;
    };
  }

  private static boolean hasCode(List<Statement> block, int from) {
    return block.subList(from, block.size()).stream().anyMatch(StatementCompiler::isCode);
  }

  private static boolean isCode(Statement statement) {
    return !(statement instanceof Statement.Label || statement instanceof Definition);
  }

  private void statement(Statement statement, boolean implied) {
    code.at(statement.range());
    if (isSimple(statement)) {
      code.beginStatement(statement.range());
      coverage.statement(statement.range(), implied);
    }
    switch (statement) {
      case Statement.Assign assign -> assignments.assign(assign);
      case Statement.Evaluate evaluate -> expressions.effect(evaluate.expression());
      case Statement.If choice -> choice(choice);
      case Statement.While loop -> loop(loop);
      case Statement.Break leave -> loops.peek().breaks().add(code.emitJump(Op.JUMP, 0));
      case Statement.Continue next -> loops.peek().continues().add(code.emitJump(Op.JUMP, 0));
      case Statement.Halt halt -> code.emit(Op.HALT, 0, 0, 0);
      case Statement.Pause pause -> code.emit(Op.PAUSE, 0, 0, 0);
      case Statement.Return leave -> giveBack(leave);
      case Statement.Join join -> expressions.handle(Op.JOIN, join.handle());
      case Statement.Kill kill -> expressions.handle(Op.KILL, kill.handle());
      case Statement.EnterCritical enter -> code.emit(Op.ENTER_CRITICAL, 0, 0, 0);
      case Statement.ExitCritical exit -> code.emit(Op.EXIT_CRITICAL, 0, 0, 0);
      case Statement.Label label -> context.label(label);
      case Definition definition -> {}
    }
  }

  /** Whether it is one step, which has no blocks and does something. */
  private static boolean isSimple(Statement statement) {
    return isCode(statement)
        && !(statement instanceof Statement.If || statement instanceof Statement.While);
  }

  private void giveBack(Statement.Return leave) {
    if (leave.value().isPresent()) {
      expressions.giveBack(leave.value().get());
    } else {
      code.emit(Op.RETURN_NONE, 0, 0, 0);
    }
  }

  private void choice(Statement.If choice) {
    List<Integer> ends = new ArrayList<>();
    int before = CoveragePoints.NONE;
    int left = choice.branches().size();
    for (Statement.Branch branch : choice.branches()) {
      left--;
      List<Integer> otherwise = new ArrayList<>();
      SourceRange head = head(branch, branch.condition());
      code.beginStatement(head);
      if (before != CoveragePoints.NONE) {
        coverage.enter(before, false);
      }
      coverage.statement(head, false);
      int decision = decision(branch.condition());
      conditions.condition(branch.condition(), false, otherwise);
      decided(decision, true, branch.body());
      block(branch.body(), decision, true);
      ends.add(code.emitJump(Op.JUMP, 0));
      otherwise.forEach(jump -> code.land(jump, code.size()));
      decided(decision, false, left == 0 ? choice.otherwise().orElse(List.of()) : List.of());
      before = decision;
    }
    if (choice.otherwise().isPresent()) {
      block(choice.otherwise().get(), before, false);
    }
    ends.forEach(jump -> code.land(jump, code.size()));
  }

  /** The statements that only {@code truth} of {@code decision} leads to. */
  private void block(List<Statement> body, int decision, boolean truth) {
    coverage.enter(decision, truth);
    statements(body);
    coverage.leave();
  }

  private void loop(Statement.While loop) {
    Expression condition = loop.condition();
    SourceRange head = head(loop, condition);
    boolean decides = !ConditionCompiler.isConstant(condition);
    if (!decides) {
      // once is enough, and turns begin with the first statement in the loop as without coverage
      coverage.statement(head, false);
    }
    int top = code.size();
    code.beginStatement(head);
    if (decides) {
      coverage.statement(head, false);
    }
    int decision = decision(condition);
    Loop ways = new Loop(new ArrayList<>(), new ArrayList<>());
    List<Integer> otherwise = new ArrayList<>();
    conditions.condition(condition, false, otherwise);
    decided(decision, true, loop.body());
    int body = code.size();
    loops.push(ways);
    block(loop.body(), decision, true);
    loops.pop();
    ways.continues().forEach(jump -> code.land(jump, code.size()));
    code.at(condition.range());
    if (ConditionCompiler.repeatsInPlace(condition)) {
      code.beginStatement(head);
    }
    int again = marksItself(loop.body()) ? decision : CoveragePoints.NONE;
    conditions.repeat(condition, again, top, body).ifPresent(otherwise::add);
    otherwise.forEach(jump -> code.land(jump, code.size()));
    coverage.decided(decision, false);
    ways.breaks().forEach(jump -> code.land(jump, code.size()));
  }

  /** A decision leads to {@code block}, which may tell of it by its own marks. */
  private void decided(int decision, boolean truth, List<Statement> block) {
    if (marksItself(block)) {
      coverage.decided(decision, truth);
    }
  }

  /** Whether the way into {@code block} is marked before its first statement. */
  private static boolean marksItself(List<Statement> block) {
    for (int i = 0; i < block.size(); i++) {
      if (isCode(block.get(i))) {
        return !isImplied(block, i);
      }
    }
    return true;
  }

  /** The coverage of what decides; constants do not. */
  private int decision(Expression condition) {
    return ConditionCompiler.isConstant(condition)
        ? CoveragePoints.NONE
        : coverage.branch(condition.range());
  }

  private static SourceRange head(Node whole, Expression condition) {
    return new SourceRange(whole.range().start(), condition.range().end());
  }
}
