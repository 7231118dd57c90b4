package org.pendant.language.parse;

import java.util.List;
import java.util.stream.Collectors;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;

/** A tree as text that shows its whole structure and no ranges, for comparing trees. */
public final class TreeShape {
  private TreeShape() {}

  /** The shape of a whole script. */
  public static String of(Script script) {
    return statements(script.statements());
  }

  private static String statements(List<Statement> statements) {
    return statements.stream().map(TreeShape::of).collect(Collectors.joining(" ", "{", "}"));
  }

  static String of(Statement statement) {
    return switch (statement) {
      case Statement.Assign assign ->
          "(set " + assign.qualifier() + " " + of(assign.target()) + " " + of(assign.value()) + ")";
      case Statement.Evaluate evaluate -> "(do " + of(evaluate.expression()) + ")";
      case Statement.If choice ->
          "(if "
              + choice.branches().stream()
                  .map(branch -> of(branch.condition()) + statements(branch.body()))
                  .collect(Collectors.joining(" elif "))
              + choice.otherwise().map(body -> " else " + statements(body)).orElse("")
              + ")";
      case Statement.While loop -> "(while " + of(loop.condition()) + statements(loop.body()) + ")";
      case Statement.Break _ -> "break";
      case Statement.Continue _ -> "continue";
      case Statement.Halt _ -> "halt";
      case Statement.Pause _ -> "pause";
      case Statement.Return back ->
          "(return" + back.value().map(value -> " " + of(value)).orElse("") + ")";
      case Statement.Join join -> "(join " + of(join.handle()) + ")";
      case Statement.Kill kill -> "(kill " + of(kill.handle()) + ")";
      case Statement.EnterCritical _ -> "enter";
      case Statement.ExitCritical _ -> "exit";
      case Statement.Label label ->
          "(label " + label.number().map(String::valueOf).orElse("-") + " " + label.text() + ")";
      case Statement.Definition definition ->
          "("
              + definition.kind()
              + " "
              + definition.name()
              + definition.parameters().stream()
                  .map(TreeShape::of)
                  .collect(Collectors.joining(" ", "[", "]"))
              + statements(definition.body())
              + ")";
    };
  }

  private static String of(ParameterDeclaration parameter) {
    return parameter.name() + parameter.defaultValue().map(value -> "=" + of(value)).orElse("");
  }

  static String of(Expression expression) {
    return switch (expression) {
      case Expression.IntLiteral number -> Integer.toString(number.value());
      case Expression.FloatLiteral number -> Double.toString(number.value());
      case Expression.StringLiteral string -> "\"" + string.value() + "\"";
      case Expression.BoolLiteral bool -> bool.value() ? "True" : "False";
      case Expression.NoneLiteral _ -> "None";
      case Expression.PoseLiteral pose -> "p" + list(pose.elements());
      case Expression.ListLiteral list -> list(list.elements());
      case Expression.Name name -> name.name();
      case Expression.Unary unary ->
          "(" + unary.operator().text() + " " + of(unary.operand()) + ")";
      case Expression.Binary binary ->
          "(" + of(binary.left()) + " " + binary.operator().text() + " " + of(binary.right()) + ")";
      case Expression.Call call -> call.function() + arguments(call.arguments());
      case Expression.MethodCall call ->
          "<" + of(call.receiver()) + ">." + call.method() + arguments(call.arguments());
      case Expression.Member member -> "<" + of(member.receiver()) + ">." + member.member();
      case Expression.Index index -> "<" + of(index.receiver()) + ">" + list(index.indices());
      case Expression.Run run -> "(run " + run.thread() + arguments(run.arguments()) + ")";
    };
  }

  private static String list(List<Expression> elements) {
    return elements.stream().map(TreeShape::of).collect(Collectors.joining(", ", "[", "]"));
  }

  private static String arguments(List<Argument> arguments) {
    return arguments.stream()
        .map(argument -> argument.name().map(name -> name + "=").orElse("") + of(argument.value()))
        .collect(Collectors.joining(", ", "(", ")"));
  }
}
