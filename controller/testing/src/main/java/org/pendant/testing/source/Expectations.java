package org.pendant.testing.source;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Argument;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Expression.StringLiteral;
import org.pendant.language.syntax.Expression.Unary;
import org.pendant.language.syntax.Expression.UnaryOperator;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Evaluate;
import org.pendant.testing.builtin.ExpectationBuiltins;

/**
 * Expectations over time as loops: a condition that is to be evaluated in every frame cannot be the
 * argument of a call, whose arguments are evaluated once. Where the arguments are not as they must
 * be, the call stays, and the checker says what is wrong with it.
 */
final class Expectations {
  private static final int MAX_SHOWN = 120;

  private final Source source;
  private int loops;

  Expectations(Source source) {
    this.source = source;
  }

  /** The same statements with loops in place of expectations. */
  List<Statement> asLoops(List<Statement> statements) {
    List<Statement> changed = new ArrayList<>(statements.size());
    for (Statement each : statements) {
      switch (each) {
        case Evaluate evaluate when evaluate.expression() instanceof Call call ->
            changed.addAll(expectation(evaluate, call));
        case Statement.If choice ->
            changed.add(
                new Statement.If(
                    choice.branches().stream()
                        .map(
                            branch ->
                                new Statement.Branch(
                                    branch.condition(), asLoops(branch.body()), branch.range()))
                        .toList(),
                    choice.otherwise().map(this::asLoops),
                    choice.range()));
        case Statement.While loop ->
            changed.add(new Statement.While(loop.condition(), asLoops(loop.body()), loop.range()));
        case Statement.Definition definition ->
            changed.add(Definitions.withBody(definition, asLoops(definition.body())));
        default -> changed.add(each);
      }
    }
    return changed;
  }

  private List<Statement> expectation(Evaluate statement, Call call) {
    return switch (call.function()) {
      case "eventually" ->
          Given.of(call, "within").map(given -> eventually(call, given)).orElse(List.of(statement));
      case "always", "never" ->
          Given.of(call, "during").map(given -> throughout(call, given)).orElse(List.of(statement));
      default -> List.of(statement);
    };
  }

  private List<Statement> eventually(Call call, Given given) {
    SourceRange range = call.range();
    Expression within =
        given.time().orElse(new Expression.FloatLiteral(ExpectationBuiltins.USUAL_S, range));
    Name deadline = new Name("$until" + loops++, range);
    Statement wait =
        new Evaluate(
            call(
                ExpectationBuiltins.AWAIT,
                range,
                List.of(deadline, text(given.condition()), given.message(range))),
            range);
    return List.of(
        new Assign(
            Statement.Qualifier.LOCAL,
            deadline,
            call(ExpectationBuiltins.DEADLINE, range, List.of(within)),
            range),
        new Statement.While(not(given.condition()), List.of(wait), range));
  }

  private List<Statement> throughout(Call call, Given given) {
    SourceRange range = call.range();
    Name deadline = new Name("$until" + loops++, range);
    Expression end =
        given.time().isPresent()
            ? call(ExpectationBuiltins.DEADLINE, range, List.of(given.time().get()))
            : new Expression.IntLiteral(-1, range);
    Statement broken =
        new Evaluate(
            call(
                ExpectationBuiltins.BROKEN,
                range,
                List.of(
                    new StringLiteral(call.function(), range),
                    text(given.condition()),
                    given.message(range))),
            range);
    Expression wrong = call.function().equals("never") ? given.condition() : not(given.condition());
    Statement check =
        new Statement.If(
            List.of(new Statement.Branch(wrong, List.of(broken), range)), Optional.empty(), range);
    Statement next = new Evaluate(call("sync", range, List.of()), range);
    return List.of(
        new Assign(Statement.Qualifier.LOCAL, deadline, end, range),
        new Statement.While(
            call(ExpectationBuiltins.STILL, range, List.of(deadline)),
            List.of(check, next),
            range));
  }

  private StringLiteral text(Expression condition) {
    String text = source.text(condition.range()).replaceAll("\\s+", " ");
    String shown = text.length() > MAX_SHOWN ? text.substring(0, MAX_SHOWN) + "..." : text;
    return new StringLiteral(shown, condition.range());
  }

  private static Expression not(Expression condition) {
    return new Unary(UnaryOperator.NOT, condition, condition.range());
  }

  static Call call(String function, SourceRange range, List<Expression> arguments) {
    return new Call(
        function,
        range,
        arguments.stream().map(each -> new Argument(Optional.empty(), each, each.range())).toList(),
        range);
  }

  /** The arguments of an expectation, by what they are. */
  private record Given(Expression condition, Optional<Expression> time, Optional<Expression> said) {

    /** Empty where they are not as they must be. */
    static Optional<Given> of(Call call, String timeName) {
      List<String> names = List.of("condition", timeName, "message");
      List<Optional<Expression>> values = new ArrayList<>();
      names.forEach(_ -> values.add(Optional.empty()));
      int next = 0;
      for (Argument each : call.arguments()) {
        int at = each.name().isPresent() ? names.indexOf(each.name().get()) : next++;
        if (at < 0 || at >= names.size() || values.get(at).isPresent()) {
          return Optional.empty();
        }
        values.set(at, Optional.of(each.value()));
      }
      return values.get(0).map(condition -> new Given(condition, values.get(1), values.get(2)));
    }

    Expression message(SourceRange range) {
      return said.orElse(new StringLiteral("", range));
    }
  }
}
