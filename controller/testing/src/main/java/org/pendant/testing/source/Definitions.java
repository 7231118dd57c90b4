package org.pendant.testing.source;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Expression.StringLiteral;
import org.pendant.language.syntax.ParameterDeclaration;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.testing.builtin.MockBuiltins;

/** Definitions of functions, changed or shown. */
final class Definitions {
  private Definitions() {}

  /** The same function with another body. */
  static Definition withBody(Definition definition, List<Statement> body) {
    return new Definition(
        definition.kind(),
        definition.name(),
        definition.nameRange(),
        definition.parameters(),
        body,
        definition.headRange(),
        definition.range());
  }

  /** Shows every function and thread, those inside others included. */
  static void each(List<Statement> statements, Consumer<Definition> visitor) {
    for (Statement each : statements) {
      switch (each) {
        case Definition definition -> {
          visitor.accept(definition);
          each(definition.body(), visitor);
        }
        case Statement.If choice -> {
          choice.branches().forEach(branch -> each(branch.body(), visitor));
          choice.otherwise().ifPresent(body -> each(body, visitor));
        }
        case Statement.While loop -> each(loop.body(), visitor);
        default -> {}
      }
    }
  }

  /**
   * The same script in which functions first ask whether a mock stands in for them.
   *
   * @param names of the functions
   */
  static Script mockable(Script script, Set<String> names) {
    return new Script(script.source(), mockable(script.statements(), names), script.range());
  }

  /** As {@link #mockable(Script, Set)}, of statements. */
  static List<Statement> mockable(List<Statement> statements, Set<String> names) {
    if (names.isEmpty()) {
      return statements;
    }
    List<Statement> changed = new ArrayList<>(statements.size());
    for (Statement each : statements) {
      changed.add(each instanceof Definition definition ? mockable(definition, names) : each);
    }
    return changed;
  }

  private static Definition mockable(Definition definition, Set<String> names) {
    List<Statement> body = mockable(definition.body(), names);
    if (!names.contains(definition.name())
        || definition.kind() != Statement.DefinitionKind.FUNCTION
        || definition.parameters().size() > MockBuiltins.MAX_PARAMETERS) {
      return withBody(definition, body);
    }
    SourceRange head = definition.nameRange();
    Expression name = new StringLiteral(definition.name(), head);
    long needed =
        definition.parameters().stream().filter(each -> each.defaultValue().isEmpty()).count();
    List<Expression> arguments =
        new ArrayList<>(List.of(name, new Expression.IntLiteral((int) needed, head)));
    for (ParameterDeclaration parameter : definition.parameters()) {
      arguments.add(new Name(parameter.name(), head));
    }
    Statement answer =
        new Statement.Return(
            Optional.of(Expectations.call(MockBuiltins.ANSWER, head, arguments)), head);
    Statement first =
        new Statement.If(
            List.of(
                new Statement.Branch(
                    Expectations.call(MockBuiltins.IS_MOCKED, head, List.of(name)),
                    List.of(answer),
                    head)),
            Optional.empty(),
            head);
    List<Statement> longer = new ArrayList<>(List.of(first));
    longer.addAll(body);
    return withBody(definition, longer);
  }
}
