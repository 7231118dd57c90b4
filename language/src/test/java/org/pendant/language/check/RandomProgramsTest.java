package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Comparator;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.syntax.Expression.Name;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.If;
import org.pendant.language.syntax.Statement.While;

/** Programs of random assignments in nested functions. */
final class RandomProgramsTest {
  private static final int PROGRAMS = 300;

  @ParameterizedTest
  @ValueSource(longs = {1, 20, 300})
  void everyAssignedNameIsAListedGlobalOrLocal(long seed) {
    Random random = new Random(seed);
    for (int i = 0; i < PROGRAMS; i++) {
      String text = "def prog():\n" + statements(random, 3) + "end\n";
      ProgramForm form = ProgramForm.of(Checks.parse(text));
      Scopes scopes = Scopes.of(form);
      for (Definition definition : scopes.definitions()) {
        assertTargetsAreListed(scopes, scopes.scope(definition), definition.body(), text);
      }
      List<Diagnostic> found = Checker.check(form, scopes, new SmallCatalogue());
      assertEquals(
          found.stream().sorted(Comparator.comparingInt(d -> d.range().start())).toList(),
          found,
          text);
      assertEquals(found, Checks.diagnostics(text), text);
    }
  }

  private static void assertTargetsAreListed(
      Scopes scopes, FunctionScope scope, List<Statement> statements, String text) {
    for (Statement statement : statements) {
      switch (statement) {
        case Assign assign -> {
          Binding target = scope.target(assign);
          boolean listed =
              switch (target) {
                case Binding.Global global -> scopes.globals().contains(global.name());
                case Binding.Local local -> scope.locals().contains(local.name());
              };
          assertTrue(listed, () -> target + " is not listed in\n" + text);
          assertEquals(((Name) assign.target()).name(), target.name(), text);
        }
        case If choice ->
            choice
                .branches()
                .forEach(branch -> assertTargetsAreListed(scopes, scope, branch.body(), text));
        case While loop -> assertTargetsAreListed(scopes, scope, loop.body(), text);
        default -> {}
      }
    }
  }

  private static String statements(Random random, int depth) {
    StringBuilder text = new StringBuilder();
    for (int i = random.nextInt(4); i >= 0; i--) {
      text.append(statement(random, depth));
    }
    return text.toString();
  }

  private static String statement(Random random, int depth) {
    String name = name(random);
    int kind = random.nextInt(depth > 0 ? 10 : 6);
    return switch (kind) {
      case 0, 1 -> name + " = " + value(random) + "\n";
      case 2 -> "local " + name + " = " + value(random) + "\n";
      case 3 -> "global " + name + " = " + value(random) + "\n";
      case 4 -> "textmsg(" + value(random) + ")\n";
      case 5 -> "f" + name + "(" + value(random) + ")\n";
      case 6 -> "if " + value(random) + ":\n" + statements(random, depth - 1) + "end\n";
      case 7 -> "while " + value(random) + ":\n" + statements(random, depth - 1) + "end\n";
      default -> "def f" + name + "(a):\n" + statements(random, depth - 1) + "end\n";
    };
  }

  private static String value(Random random) {
    return switch (random.nextInt(5)) {
      case 0 -> "1";
      case 1 -> "\"text\"";
      case 2 -> "[1, " + name(random) + "]";
      case 3 -> name(random) + " + " + name(random);
      default -> name(random);
    };
  }

  private static String name(Random random) {
    return String.valueOf((char) ('a' + random.nextInt(4)));
  }
}
