package org.pendant.language.parse;

import java.util.List;
import java.util.random.RandomGenerator;
import java.util.stream.Collectors;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.UnaryOperator;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;

/**
 * Writes a tree as script text, with random layout: brackets only where precedence needs them or by
 * chance, statements on one line or several.
 */
public final class ScriptPrinter {
  private static final int POSTFIX = 8;

  private final RandomGenerator random;

  /** A printer whose layout is drawn from {@code random}. */
  public ScriptPrinter(RandomGenerator random) {
    this.random = random;
  }

  /** The text of {@code statements}. */
  public String print(List<Statement> statements) {
    StringBuilder text = new StringBuilder();
    for (Statement statement : statements) {
      boolean line = statement instanceof Statement.Label;
      boolean ownLine = line || random.nextInt(3) > 0;
      text.append(ownLine ? lineEnd() : " ").append(print(statement));
      if (line) {
        text.append('\n');
      } else if (statement instanceof Statement.Return) {
        text.append(lineEnd());
      }
    }
    return text.toString();
  }

  private String lineEnd() {
    String indent = " ".repeat(random.nextInt(4));
    return switch (random.nextInt(6)) {
      case 0 -> "\r\n" + indent;
      case 1 -> "  # \"comment: (\n" + indent;
      case 2 -> "\n\n\t";
      default -> "\n" + indent;
    };
  }

  private String print(Statement statement) {
    return switch (statement) {
      case Statement.Assign assign ->
          switch (assign.qualifier()) {
                case FREE -> "";
                case LOCAL -> "local ";
                case GLOBAL -> "global ";
              }
              + print(assign.target(), 0)
              + blank()
              + "="
              + (random.nextInt(8) == 0 ? lineEnd() : blank())
              + print(assign.value(), 0);
      case Statement.Evaluate evaluate -> print(evaluate.expression(), 0);
      case Statement.If choice -> {
        StringBuilder text = new StringBuilder();
        String word = "if ";
        for (Statement.Branch branch : choice.branches()) {
          text.append(word).append(print(branch.condition(), 0)).append(blank()).append(':');
          text.append(print(branch.body()));
          word = "\nelif ";
        }
        choice.otherwise().ifPresent(body -> text.append("\nelse:").append(print(body)));
        yield text + " end";
      }
      case Statement.While loop ->
          "while " + print(loop.condition(), 0) + ":" + print(loop.body()) + "\nend";
      case Statement.Break _ -> "break";
      case Statement.Continue _ -> "continue";
      case Statement.Halt _ -> "halt";
      case Statement.Pause _ -> "pause";
      case Statement.Return back ->
          "return" + back.value().map(value -> " " + print(value, 0)).orElse("");
      case Statement.Join join -> "join " + print(join.handle(), 0);
      case Statement.Kill kill -> "kill " + print(kill.handle(), 0);
      case Statement.EnterCritical _ -> "enter_critical";
      case Statement.ExitCritical _ -> "exit_critical";
      case Statement.Label label ->
          "$ "
              + label.number().map(n -> n + " ").orElse("")
              + "\""
              + label.text()
              + "\" \"noBreak\"";
      case Statement.Definition definition ->
          switch (definition.kind()) {
                case FUNCTION -> "def ";
                case SECONDARY -> "sec ";
                case THREAD -> "thread ";
              }
              + definition.name()
              + definition.parameters().stream()
                  .map(this::print)
                  .collect(Collectors.joining("," + blank(), "(", ")"))
              + blank()
              + ":"
              + print(definition.body())
              + "\nend";
    };
  }

  private String print(ParameterDeclaration parameter) {
    return parameter.name() + parameter.defaultValue().map(v -> "=" + print(v, 0)).orElse("");
  }

  /** {@code expression}, in brackets if it binds more loosely than {@code loosest}. */
  private String print(Expression expression, int loosest) {
    String text = bare(expression);
    boolean needed = precedence(expression) < loosest;
    return needed || (random.nextInt(12) == 0 && bracketsLeaveNoTrace(expression))
        ? "(" + text + ")"
        : text;
  }

  private static boolean bracketsLeaveNoTrace(Expression expression) {
    return expression instanceof Expression.Binary || expression instanceof Expression.Unary;
  }

  private String bare(Expression expression) {
    return switch (expression) {
      case Expression.IntLiteral number -> Integer.toString(number.value());
      case Expression.FloatLiteral number -> Double.toString(number.value());
      case Expression.StringLiteral string -> "\"" + string.value() + "\"";
      case Expression.BoolLiteral bool -> bool.value() ? "True" : "False";
      case Expression.NoneLiteral _ -> "None";
      case Expression.PoseLiteral pose -> "p" + list(pose.elements());
      case Expression.ListLiteral list -> list(list.elements());
      case Expression.Name name -> name.name();
      case Expression.Unary unary -> {
        boolean not = unary.operator() == UnaryOperator.NOT;
        yield (not ? (random.nextBoolean() ? "not " : "!") : unary.operator().text())
            + print(unary.operand(), not ? 3 : 7);
      }
      case Expression.Binary binary -> {
        int precedence = precedence(binary);
        yield print(binary.left(), precedence)
            + " "
            + binary.operator().text()
            + (random.nextInt(10) == 0 ? lineEnd() : " ")
            + print(binary.right(), precedence + 1);
      }
      case Expression.Call call -> call.function() + arguments(call.arguments());
      case Expression.MethodCall call ->
          print(call.receiver(), POSTFIX) + "." + call.method() + arguments(call.arguments());
      case Expression.Member member -> print(member.receiver(), POSTFIX) + "." + member.member();
      case Expression.Index index -> print(index.receiver(), POSTFIX) + list(index.indices());
      case Expression.Run run -> "run " + run.thread() + arguments(run.arguments());
    };
  }

  private static int precedence(Expression expression) {
    return switch (expression) {
      case Expression.Binary binary -> precedence(binary.operator());
      case Expression.Unary unary -> unary.operator() == UnaryOperator.NOT ? 3 : 7;
      // Digits in front of a dot would read as a float, and a handle has no members.
      case Expression.IntLiteral _, Expression.FloatLiteral _, Expression.Run _ -> 7;
      default -> POSTFIX;
    };
  }

  private static int precedence(BinaryOperator operator) {
    return switch (operator) {
      case OR, XOR -> 1;
      case AND -> 2;
      case EQUAL, NOT_EQUAL, LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL -> 4;
      case ADD, SUBTRACT -> 5;
      case MULTIPLY, DIVIDE, MODULO -> 6;
    };
  }

  private String list(List<Expression> elements) {
    return elements.stream()
        .map(element -> print(element, 0))
        .collect(Collectors.joining("," + gap(), "[", gap() + "]"));
  }

  private String arguments(List<Argument> arguments) {
    return arguments.stream()
        .map(
            argument ->
                argument.name().map(name -> name + blank() + "=" + blank()).orElse("")
                    + print(argument.value(), 0))
        .collect(Collectors.joining(gap() + ",", "(" + gap(), ")"));
  }

  private String gap() {
    return random.nextInt(10) == 0 ? lineEnd() : blank();
  }

  private String blank() {
    return random.nextBoolean() ? " " : "";
  }
}
