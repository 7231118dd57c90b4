package org.pendant.testing.mutation;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.BinaryOperator;
import org.pendant.language.syntax.Expression.BoolLiteral;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.UnaryOperator;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** Mutation finder: all mutations of one program. */
final class MutationFinder {
  /** Calls whose absence nobody but the log tells, and those that only wait for a frame. */
  private static final Set<String> NOT_MISSED = Set.of("textmsg", "varmsg", "sync", "popup_close");

  private final Source source;
  private final Builtins<ControlBox> builtins;
  private final Set<String> functions = new HashSet<>();
  private final List<Mutation> found = new ArrayList<>();

  private MutationFinder(Source source, Builtins<ControlBox> builtins) {
    this.source = source;
    this.builtins = builtins;
  }

  /**
   * All mutations of a program, in the order of its text; none of one with errors.
   *
   * @param builtins what it may call
   */
  static List<Mutation> in(Source source, Builtins<ControlBox> builtins) {
    Script script = ScriptParser.parseProgram(source).script();
    MutationFinder finder = new MutationFinder(source, builtins);
    finder.names(script.statements());
    finder.statements(script.statements());
    finder.found.sort(
        Comparator.comparingInt((Mutation each) -> each.range().start())
            .thenComparingInt(each -> each.range().end())
            .thenComparing(Mutation::kind));
    return finder.found;
  }

  private void names(List<Statement> statements) {
    for (Statement each : statements) {
      if (each instanceof Definition definition) {
        functions.add(definition.name());
        names(definition.body());
      }
    }
  }

  private int line(SourceRange range) {
    return source.line(range.start());
  }

  private void statements(List<Statement> statements) {
    statements.forEach(this::statement);
  }

  private void statement(Statement statement) {
    int line = line(statement.range());
    switch (statement) {
      case Statement.Assign assign -> {
        expressions(line).look(assign.target());
        expressions(line).look(assign.value());
      }
      case Statement.Evaluate evaluate -> {
        if (evaluate.expression() instanceof Call call) {
          dropped(call, evaluate.range(), line);
        }
        expressions(line).look(evaluate.expression());
      }
      case Statement.If choice -> {
        for (Statement.Branch branch : choice.branches()) {
          condition(branch.condition(), line(branch.range()));
          statements(branch.body());
        }
        choice.otherwise().ifPresent(this::statements);
      }
      case Statement.While loop -> {
        condition(loop.condition(), line);
        statements(loop.body());
      }
      case Statement.Return back -> back.value().ifPresent(value -> returned(value, line));
      case Definition definition -> {
        if (!definition.body().isEmpty()) {
          int first = line(definition.body().getFirst().range());
          definition
              .parameters()
              .forEach(each -> each.defaultValue().ifPresent(expressions(first)::look));
        }
        statements(definition.body());
      }
      case Statement.Join _,
          Statement.Kill _,
          Statement.Break _,
          Statement.Continue _,
          Statement.Halt _,
          Statement.Pause _,
          Statement.EnterCritical _,
          Statement.ExitCritical _,
          Statement.Label _ -> {}
    }
  }

  private ExpressionMutations expressions(int reach) {
    return new ExpressionMutations(source, builtins, reach, found);
  }

  /** A call that is left out, unless its answer is all that there is to it. */
  private void dropped(Call call, SourceRange range, int line) {
    Optional<Builtin<ControlBox>> builtin = builtins.find(call.function());
    boolean moves = builtin.filter(each -> each.effect() == Effect.MOVES).isPresent();
    boolean acts =
        functions.contains(call.function())
            || builtin.filter(each -> acts(each.effect())).isPresent();
    if (acts && !NOT_MISSED.contains(call.function())) {
      found.add(
          new Mutation(
              moves ? MutationKind.MOVE_DROPPED : MutationKind.CALL_DROPPED, range, "", line));
    }
  }

  private static boolean acts(Effect effect) {
    return switch (effect) {
      case MOVES, TELLS, SETS, CHANGES -> true;
      case COMPUTES, ASKS, SENSES, ASKS_GOAL -> false;
    };
  }

  private void condition(Expression condition, int line) {
    expressions(line).look(condition);
    if (!(condition instanceof BoolLiteral) && !isEquality(condition)) {
      inverted(MutationKind.CONDITION, condition, line);
    }
  }

  /** Its other way round is what another comparison makes of it. */
  private static boolean isEquality(Expression expression) {
    return expression instanceof Expression.Binary binary
        && (binary.operator() == BinaryOperator.EQUAL
            || binary.operator() == BinaryOperator.NOT_EQUAL);
  }

  private void inverted(MutationKind kind, Expression expression, int line) {
    String text =
        expression instanceof Expression.Unary unary && unary.operator() == UnaryOperator.NOT
            ? source.text(unary.operand().range())
            : "not (" + source.text(expression.range()) + ")";
    found.add(new Mutation(kind, expression.range(), text, line));
  }

  private void returned(Expression value, int line) {
    expressions(line).look(value);
    switch (value) {
      case Expression.PoseLiteral _ -> replaced(value, "p[0, 0, 0, 0, 0, 0]", line);
      case Expression.Unary unary when unary.operator() == UnaryOperator.NOT ->
          inverted(MutationKind.RETURN, value, line);
      case Expression.Binary binary when isTruth(binary.operator()) ->
          inverted(MutationKind.RETURN, value, line);
      case Call call ->
          builtins
              .find(call.function())
              .ifPresent(
                  builtin -> {
                    switch (builtin.signature().result()) {
                      case BOOL -> inverted(MutationKind.RETURN, value, line);
                      case INT, NUMBER -> replaced(value, "0", line);
                      case STRING -> replaced(value, "\"\"", line);
                      case POSE -> replaced(value, "p[0, 0, 0, 0, 0, 0]", line);
                      case JOINTS -> replaced(value, "[0, 0, 0, 0, 0, 0]", line);
                      case ANY,
                          NONE,
                          LIST,
                          POSE_OR_JOINTS,
                          MATRIX,
                          STRUCT,
                          RPC_HANDLE,
                          EIP_HANDLE -> {}
                    }
                  });
      // what others are is not known before they run
      default -> {}
    }
  }

  private static boolean isTruth(BinaryOperator operator) {
    return switch (operator) {
      case OR, XOR, AND, LESS, GREATER, LESS_OR_EQUAL, GREATER_OR_EQUAL -> true;
      // the other comparison does the same
      case EQUAL, NOT_EQUAL -> false;
      case ADD, SUBTRACT, MULTIPLY, DIVIDE, MODULO -> false;
    };
  }

  private void replaced(Expression value, String text, int line) {
    found.add(new Mutation(MutationKind.RETURN, value.range(), text, line));
  }
}
