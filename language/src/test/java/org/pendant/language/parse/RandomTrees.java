package org.pendant.language.parse;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.random.RandomGenerator;
import java.util.stream.Stream;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.UnaryOperator;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Statement;

/** Makes random trees of every kind of node, with empty ranges. */
public final class RandomTrees {
  private static final SourceRange NOWHERE = new SourceRange(0, 0);
  private static final List<String> NAMES =
      List.of("a", "b", "p", "x1", "_t", "movej", "endless", "iffy", "Name_2", "e5", "P");

  private final RandomGenerator random;

  /** Trees drawn from {@code random}. */
  public RandomTrees(RandomGenerator random) {
    this.random = random;
  }

  /** Up to four statements with blocks inside each other {@code depth} deep. */
  public List<Statement> statements(int depth) {
    return some(5, () -> statement(depth));
  }

  private Statement statement(int depth) {
    return switch (random.nextInt(depth > 0 ? 18 : 13)) {
      case 0, 1 -> new Statement.Assign(Statement.Qualifier.FREE, target(), expression(3), NOWHERE);
      case 2 -> new Statement.Assign(Statement.Qualifier.GLOBAL, name(), expression(3), NOWHERE);
      case 3 -> new Statement.Assign(Statement.Qualifier.LOCAL, name(), expression(3), NOWHERE);
      case 4, 5 -> new Statement.Evaluate(call(2), NOWHERE);
      case 6 -> new Statement.Evaluate(run(), NOWHERE);
      case 7 -> new Statement.Return(maybe(() -> expression(3)), NOWHERE);
      case 8 -> new Statement.Join(expression(1), NOWHERE);
      case 9 -> new Statement.Kill(name(), NOWHERE);
      case 10 ->
          switch (random.nextInt(6)) {
            case 0 -> new Statement.Break(NOWHERE);
            case 1 -> new Statement.Continue(NOWHERE);
            case 2 -> new Statement.Halt(NOWHERE);
            case 3 -> new Statement.Pause(NOWHERE);
            case 4 -> new Statement.EnterCritical(NOWHERE);
            default -> new Statement.ExitCritical(NOWHERE);
          };
      case 11 -> new Statement.Label(maybe(() -> random.nextInt(1000)), "x = \"(1\" # é", NOWHERE);
      case 12 -> new Statement.Evaluate(method(2), NOWHERE);
      case 13 ->
          new Statement.If(
              Stream.generate(
                      () -> new Statement.Branch(expression(2), statements(depth - 1), NOWHERE))
                  .limit(1 + random.nextInt(3))
                  .toList(),
              maybe(() -> statements(depth - 1)),
              NOWHERE);
      case 14, 15 -> new Statement.While(expression(2), statements(depth - 1), NOWHERE);
      default -> definition(depth);
    };
  }

  private Statement definition(int depth) {
    Statement.DefinitionKind kind = oneOf(List.of(Statement.DefinitionKind.values()));
    List<ParameterDeclaration> parameters =
        kind == Statement.DefinitionKind.THREAD
            ? List.of()
            : some(3, () -> new ParameterDeclaration(word(), maybe(() -> expression(1)), NOWHERE));
    return new Statement.Definition(
        kind, word(), NOWHERE, parameters, statements(depth - 1), NOWHERE, NOWHERE);
  }

  private Expression expression(int depth) {
    if (depth == 0) {
      return literal();
    }
    return switch (random.nextInt(12)) {
      case 0, 1 ->
          new Expression.Binary(
              oneOf(List.of(BinaryOperator.values())),
              expression(depth - 1),
              expression(depth - 1),
              NOWHERE);
      case 2 ->
          new Expression.Unary(
              oneOf(List.of(UnaryOperator.values())), expression(depth - 1), NOWHERE);
      case 3 -> call(depth - 1);
      case 4 -> method(depth - 1);
      case 5 -> new Expression.Member(expression(depth - 1), word(), NOWHERE, NOWHERE);
      case 6 -> index(expression(depth - 1));
      case 7 ->
          new Expression.PoseLiteral(
              Stream.generate(() -> expression(depth - 1)).limit(6).toList(), NOWHERE);
      case 8 -> new Expression.ListLiteral(some(4, () -> expression(depth - 1)), NOWHERE);
      case 9 -> run();
      default -> literal();
    };
  }

  private Expression literal() {
    return switch (random.nextInt(7)) {
      case 0 -> new Expression.IntLiteral(random.nextInt(Integer.MAX_VALUE), NOWHERE);
      case 1 -> new Expression.FloatLiteral(random.nextDouble() * 1e9, NOWHERE);
      case 2 -> new Expression.FloatLiteral(random.nextDouble() * 1e-9, NOWHERE);
      case 3 -> new Expression.StringLiteral("a\\ # $ (' end", NOWHERE);
      case 4 -> new Expression.BoolLiteral(random.nextBoolean(), NOWHERE);
      case 5 -> new Expression.NoneLiteral(NOWHERE);
      default -> name();
    };
  }

  private Expression target() {
    return switch (random.nextInt(3)) {
      case 0 -> new Expression.Member(name(), word(), NOWHERE, NOWHERE);
      case 1 -> index(name());
      default -> name();
    };
  }

  private Expression index(Expression receiver) {
    return new Expression.Index(
        receiver,
        Stream.generate(() -> expression(1)).limit(1 + random.nextInt(2)).toList(),
        NOWHERE);
  }

  private Expression call(int depth) {
    return new Expression.Call(word(), NOWHERE, arguments(depth), NOWHERE);
  }

  private Expression method(int depth) {
    return new Expression.MethodCall(name(), word(), NOWHERE, arguments(depth), NOWHERE);
  }

  private Expression run() {
    return new Expression.Run(word(), NOWHERE, List.of(), NOWHERE);
  }

  private List<Argument> arguments(int depth) {
    return some(4, () -> new Argument(maybe(this::word), expression(Math.max(0, depth)), NOWHERE));
  }

  private Expression name() {
    return new Expression.Name(word(), NOWHERE);
  }

  private String word() {
    return oneOf(NAMES);
  }

  private <T> T oneOf(List<T> choices) {
    return choices.get(random.nextInt(choices.size()));
  }

  private <T> Optional<T> maybe(Supplier<T> value) {
    return random.nextBoolean() ? Optional.of(value.get()) : Optional.empty();
  }

  private <T> List<T> some(int limit, Supplier<T> value) {
    return Stream.generate(value).limit(random.nextInt(limit)).toList();
  }
}
