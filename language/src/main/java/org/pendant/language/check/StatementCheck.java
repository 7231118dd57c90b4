package org.pendant.language.check;

import static org.pendant.language.check.CheckTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Branch;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.If;
import org.pendant.language.syntax.Statement.Qualifier;
import org.pendant.language.syntax.Statement.While;

/**
 * Statement check: checks the statements of one function, thread or main level in the order of the
 * text.
 */
final class StatementCheck {
  private final CheckRun run;
  private final FunctionState state;
  private final ExpressionCheck expressions;
  private final DefinitionCheck definitions;
  private final Set<String> defined = new HashSet<>();

  StatementCheck(CheckRun run, FunctionState state) {
    this.run = run;
    this.state = state;
    this.expressions = new ExpressionCheck(run, state);
    this.definitions = new DefinitionCheck(run);
  }

  void block(List<Statement> statements) {
    boolean left = false;
    boolean reported = false;
    for (Statement statement : statements) {
      boolean runs = !(statement instanceof Definition || statement instanceof Statement.Label);
      if (left && runs && !reported) {
        reported = true;
        run.findings().warning("unreachable", statement.range(), text("unreachable"));
      }
      check(statement);
      left |=
          statement instanceof Statement.Return
              || statement instanceof Statement.Halt
              || statement instanceof Statement.Break
              || statement instanceof Statement.Continue;
    }
  }

  private void check(Statement statement) {
    switch (statement) {
      case Assign assign -> assign(assign);
      case Statement.Evaluate(Name name, _) -> alone(name);
      case Statement.Evaluate evaluate -> expressions.check(evaluate.expression());
      case If choice -> choose(choice);
      case While loop -> loop(loop);
      case Statement.Break _ -> {
        insideLoop("break", statement.range());
        state.breaks();
      }
      case Statement.Continue _ -> insideLoop("continue", statement.range());
      case Statement.Return result -> {
        result.value().ifPresent(expressions::check);
        state.leaves();
      }
      case Statement.Halt _ -> {
        state.leaves();
        state.node().waits();
      }
      case Statement.Pause _ -> state.waits();
      case Statement.Join join -> {
        expressions.handle(join.handle());
        state.waits();
        state.node().refuseInSecondary(join.range(), "joinInSecondary");
      }
      case Statement.Kill kill -> expressions.handle(kill.handle());
      case Definition definition -> {
        if (definition.kind() == Statement.DefinitionKind.THREAD) {
          state.node().refuseInSecondary(definition.nameRange(), "threadInSecondary");
        }
        if (definition.kind() == Statement.DefinitionKind.SECONDARY) {
          run.findings()
              .error(
                  "nested-secondary",
                  definition.headRange(),
                  text("nestedSecondary", definition.name()));
        }
        definitions.check(definition, state.scope().nested(definition), defined);
      }
      case Statement.EnterCritical _, Statement.ExitCritical _, Statement.Label _ -> {}
    }
  }

  /** A name as a statement: a variable's does nothing, any other is a mistake. */
  private void alone(Name name) {
    if (state.scope().knows(name.name())) {
      run.findings().warning("no-effect", name.range(), text("noEffect", name.name()));
    } else {
      run.findings()
          .nameNotFound(
              "no-effect",
              name.name(),
              name.range(),
              text("nameAlone", name.name(), name.name(), name.name()));
    }
  }

  private void assign(Assign assign) {
    Optional<Call> output = OutputAssignment.call(assign, state.scope());
    if (output.isPresent()) {
      run.assignsOutput(output.get());
      expressions.check(output.get());
      return;
    }
    StaticType kind = expressions.check(assign.value());
    if (!(assign.target() instanceof Name name)) {
      StaticType element = expressions.check(assign.target());
      if (element == StaticType.NUMBER && ExpressionCheck.isNoNumber(kind)) {
        run.findings()
            .error("type-mismatch", assign.value().range(), text("elementType", kind.text()));
      }
      return;
    }
    if (run.interpreted()
        && assign.qualifier() == Qualifier.GLOBAL
        && !state.scope().globals().contains(name.name())) {
      run.findings().error("interpreter-global", assign.range(), text("newGlobal", name.name()));
      return;
    }
    Binding binding = state.scope().target(assign);
    StaticType before = state.flow().kind(binding);
    if (!before.certain()) {
      before = run.survey().openingKind(binding);
    }
    if (before.refuses(kind)) {
      run.findings()
          .error(
              "type-change",
              assign.range(),
              text("typeChange", name.name(), before.text(), kind.text()));
    }
    state.flow().holds(binding, kind);
    state.flow().assigned(binding);
  }

  private void choose(If choice) {
    Flow.Fork fork = state.flow().fork();
    for (Branch branch : choice.branches()) {
      expressions.condition(branch.condition());
      block(branch.body());
      state.flow().endBranch(fork);
    }
    choice
        .otherwise()
        .ifPresent(
            body -> {
              block(body);
              state.flow().endBranch(fork);
            });
    state.flow().join(fork);
  }

  private void loop(While loop) {
    boolean outermost = !state.insideLoop();
    state.openLoop(Constants.alwaysTrue(loop.condition()));
    expressions.condition(loop.condition());
    if (outermost) {
      state.flow().assignedIn(state.scope(), loop.body());
    }
    Flow.Fork fork = state.flow().fork();
    block(loop.body());
    state.flow().forgetKinds(fork);
    state.closeLoop(head(loop), run.graph());
  }

  private void insideLoop(String word, SourceRange range) {
    if (!state.insideLoop()) {
      run.findings().error("outside-loop", range, text("outsideLoop", word));
    }
  }

  /** From {@code while} to the end of its condition: the whole loop may be the whole program. */
  private static SourceRange head(While loop) {
    return new SourceRange(loop.range().start(), loop.condition().range().end());
  }
}
