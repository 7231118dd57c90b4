package org.pendant.language.syntax;

import java.util.ArrayList;
import java.util.List;

/** Children: what stands directly inside a node. */
final class Children {
  private Children() {}

  static List<Node> of(Node node) {
    return switch (node) {
      case Script script -> List.copyOf(script.statements());
      case Statement statement -> ofStatement(statement);
      case Statement.Branch branch -> with(List.of(branch.condition()), branch.body());
      case Expression expression -> ofExpression(expression);
      case Argument argument -> List.of(argument.value());
      case ParameterDeclaration parameter ->
          List.copyOf(parameter.defaultValue().stream().toList());
    };
  }

  private static List<Node> ofStatement(Statement statement) {
    return switch (statement) {
      case Statement.Assign assign -> List.of(assign.target(), assign.value());
      case Statement.Evaluate evaluate -> List.of(evaluate.expression());
      case Statement.If choice -> with(choice.branches(), choice.otherwise().orElse(List.of()));
      case Statement.While loop -> with(List.of(loop.condition()), loop.body());
      case Statement.Return back -> List.copyOf(back.value().stream().toList());
      case Statement.Join join -> List.of(join.handle());
      case Statement.Kill kill -> List.of(kill.handle());
      case Statement.Definition definition -> with(definition.parameters(), definition.body());
      case Statement.Break _,
          Statement.Continue _,
          Statement.Halt _,
          Statement.Pause _,
          Statement.EnterCritical _,
          Statement.ExitCritical _,
          Statement.Label _ ->
          List.of();
    };
  }

  private static List<Node> ofExpression(Expression expression) {
    return switch (expression) {
      case Expression.PoseLiteral pose -> List.copyOf(pose.elements());
      case Expression.ListLiteral list -> List.copyOf(list.elements());
      case Expression.Unary unary -> List.of(unary.operand());
      case Expression.Binary binary -> List.of(binary.left(), binary.right());
      case Expression.Call call -> List.copyOf(call.arguments());
      case Expression.MethodCall call -> with(List.of(call.receiver()), call.arguments());
      case Expression.Member member -> List.of(member.receiver());
      case Expression.Index index -> with(List.of(index.receiver()), index.indices());
      case Expression.Run run -> List.copyOf(run.arguments());
      case Expression.IntLiteral _,
          Expression.FloatLiteral _,
          Expression.StringLiteral _,
          Expression.BoolLiteral _,
          Expression.NoneLiteral _,
          Expression.Name _ ->
          List.of();
    };
  }

  private static List<Node> with(List<? extends Node> first, List<? extends Node> then) {
    List<Node> all = new ArrayList<>(first.size() + then.size());
    all.addAll(first);
    all.addAll(then);
    return all;
  }
}
