package org.pendant.language.parse;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Branch;

/** Moved tree: statements as they are where the text in front of them got longer or shorter. */
final class MovedTree {
  private final int shift;

  private MovedTree(int shift) {
    this.shift = shift;
  }

  /** A statement {@code shift} bytes further on; itself for none. */
  static Statement moved(Statement statement, int shift) {
    return shift == 0 ? statement : new MovedTree(shift).statement(statement);
  }

  private SourceRange range(SourceRange range) {
    return new SourceRange(range.start() + shift, range.end() + shift);
  }

  private Statement statement(Statement statement) {
    SourceRange range = range(statement.range());
    return switch (statement) {
      case Statement.Assign assign ->
          new Statement.Assign(
              assign.qualifier(), expression(assign.target()), expression(assign.value()), range);
      case Statement.Evaluate evaluate ->
          new Statement.Evaluate(expression(evaluate.expression()), range);
      case Statement.If choice ->
          new Statement.If(
              list(choice.branches(), this::branch),
              choice.otherwise().map(this::statements),
              range);
      case Statement.While loop ->
          new Statement.While(expression(loop.condition()), statements(loop.body()), range);
      case Statement.Break _ -> new Statement.Break(range);
      case Statement.Continue _ -> new Statement.Continue(range);
      case Statement.Halt _ -> new Statement.Halt(range);
      case Statement.Pause _ -> new Statement.Pause(range);
      case Statement.Return back -> new Statement.Return(expression(back.value()), range);
      case Statement.Join join -> new Statement.Join(expression(join.handle()), range);
      case Statement.Kill kill -> new Statement.Kill(expression(kill.handle()), range);
      case Statement.EnterCritical _ -> new Statement.EnterCritical(range);
      case Statement.ExitCritical _ -> new Statement.ExitCritical(range);
      case Statement.Label label -> new Statement.Label(label.number(), label.text(), range);
      case Statement.Definition definition ->
          new Statement.Definition(
              definition.kind(),
              definition.name(),
              range(definition.nameRange()),
              list(definition.parameters(), this::parameter),
              statements(definition.body()),
              range(definition.headRange()),
              range);
    };
  }

  private Branch branch(Branch branch) {
    return new Branch(
        expression(branch.condition()), statements(branch.body()), range(branch.range()));
  }

  private ParameterDeclaration parameter(ParameterDeclaration parameter) {
    return new ParameterDeclaration(
        parameter.name(), expression(parameter.defaultValue()), range(parameter.range()));
  }

  private Argument argument(Argument argument) {
    return new Argument(argument.name(), expression(argument.value()), range(argument.range()));
  }

  private Optional<Expression> expression(Optional<Expression> expression) {
    return expression.map(this::expression);
  }

  private Expression expression(Expression expression) {
    SourceRange range = range(expression.range());
    return switch (expression) {
      case Expression.IntLiteral number -> new Expression.IntLiteral(number.value(), range);
      case Expression.FloatLiteral number -> new Expression.FloatLiteral(number.value(), range);
      case Expression.StringLiteral string -> new Expression.StringLiteral(string.value(), range);
      case Expression.BoolLiteral truth -> new Expression.BoolLiteral(truth.value(), range);
      case Expression.NoneLiteral _ -> new Expression.NoneLiteral(range);
      case Expression.PoseLiteral pose ->
          new Expression.PoseLiteral(expressions(pose.elements()), range);
      case Expression.ListLiteral list ->
          new Expression.ListLiteral(expressions(list.elements()), range);
      case Expression.Name name -> new Expression.Name(name.name(), range);
      case Expression.Unary unary ->
          new Expression.Unary(unary.operator(), expression(unary.operand()), range);
      case Expression.Binary binary ->
          new Expression.Binary(
              binary.operator(), expression(binary.left()), expression(binary.right()), range);
      case Expression.Call call ->
          new Expression.Call(
              call.function(), range(call.nameRange()), arguments(call.arguments()), range);
      case Expression.MethodCall call ->
          new Expression.MethodCall(
              expression(call.receiver()),
              call.method(),
              range(call.nameRange()),
              arguments(call.arguments()),
              range);
      case Expression.Member member ->
          new Expression.Member(
              expression(member.receiver()), member.member(), range(member.nameRange()), range);
      case Expression.Index index ->
          new Expression.Index(expression(index.receiver()), expressions(index.indices()), range);
      case Expression.Run run ->
          new Expression.Run(
              run.thread(), range(run.nameRange()), arguments(run.arguments()), range);
    };
  }

  private List<Statement> statements(List<Statement> statements) {
    return list(statements, this::statement);
  }

  private List<Expression> expressions(List<Expression> expressions) {
    return list(expressions, this::expression);
  }

  private List<Argument> arguments(List<Argument> arguments) {
    return list(arguments, this::argument);
  }

  /** Of the same length; one that the records of the tree take as it is. */
  private static <T> List<T> list(List<T> old, UnaryOperator<T> moved) {
    @SuppressWarnings("unchecked") // filled with T alone
    T[] elements = (T[]) new Object[old.size()];
    Arrays.setAll(elements, i -> moved.apply(old.get(i)));
    return List.of(elements);
  }
}
