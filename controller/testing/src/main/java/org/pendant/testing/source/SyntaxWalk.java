package org.pendant.testing.source;

import java.util.List;
import java.util.function.Consumer;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;

/** Walk through all expressions of a piece of syntax, outer ones first. */
final class SyntaxWalk {
  private final Consumer<Expression> visitor;
  private final boolean intoDefinitions;

  private SyntaxWalk(Consumer<Expression> visitor, boolean intoDefinitions) {
    this.visitor = visitor;
    this.intoDefinitions = intoDefinitions;
  }

  /** Shows every expression of {@code statements}, those of functions inside included. */
  static void all(List<Statement> statements, Consumer<Expression> visitor) {
    new SyntaxWalk(visitor, true).statements(statements);
  }

  /** As {@link #all}, without the functions inside. */
  static void ownOf(List<Statement> statements, Consumer<Expression> visitor) {
    new SyntaxWalk(visitor, false).statements(statements);
  }

  private void statements(List<Statement> statements) {
    statements.forEach(this::statement);
  }

  private void statement(Statement statement) {
    switch (statement) {
      case Statement.Assign assign -> {
        expression(assign.target());
        expression(assign.value());
      }
      case Statement.Evaluate evaluate -> expression(evaluate.expression());
      case Statement.If choice -> {
        for (Statement.Branch branch : choice.branches()) {
          expression(branch.condition());
          statements(branch.body());
        }
        choice.otherwise().ifPresent(this::statements);
      }
      case Statement.While loop -> {
        expression(loop.condition());
        statements(loop.body());
      }
      case Statement.Return back -> back.value().ifPresent(this::expression);
      case Statement.Join join -> expression(join.handle());
      case Statement.Kill kill -> expression(kill.handle());
      case Statement.Definition definition -> {
        for (ParameterDeclaration parameter : definition.parameters()) {
          parameter.defaultValue().ifPresent(this::expression);
        }
        if (intoDefinitions) {
          statements(definition.body());
        }
      }
      case Statement.Break _,
          Statement.Continue _,
          Statement.Halt _,
          Statement.Pause _,
          Statement.EnterCritical _,
          Statement.ExitCritical _,
          Statement.Label _ -> {}
    }
  }

  private void expression(Expression expression) {
    visitor.accept(expression);
    switch (expression) {
      case Expression.Call call -> arguments(call.arguments());
      case Expression.MethodCall call -> {
        expression(call.receiver());
        arguments(call.arguments());
      }
      case Expression.Run run -> arguments(run.arguments());
      case Expression.PoseLiteral pose -> pose.elements().forEach(this::expression);
      case Expression.ListLiteral list -> list.elements().forEach(this::expression);
      case Expression.Unary unary -> expression(unary.operand());
      case Expression.Binary binary -> {
        expression(binary.left());
        expression(binary.right());
      }
      case Expression.Member member -> expression(member.receiver());
      case Expression.Index index -> {
        expression(index.receiver());
        index.indices().forEach(this::expression);
      }
      case Expression.IntLiteral _,
          Expression.FloatLiteral _,
          Expression.StringLiteral _,
          Expression.BoolLiteral _,
          Expression.NoneLiteral _,
          Expression.Name _ -> {}
    }
  }

  private void arguments(List<Argument> arguments) {
    arguments.forEach(each -> expression(each.value()));
  }
}
