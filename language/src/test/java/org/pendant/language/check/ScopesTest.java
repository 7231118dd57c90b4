package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.language.syntax.Script;
import org.pendant.language.syntax.Statement.Definition;

final class ScopesTest {

  @Test
  void allFirstLevelVariablesAreGlobalWhateverWordStandsBefore() {
    Scopes scopes =
        scopes(
            """
            def prog():
             a = 1
             local b = 2
             if a > 0:
              while True:
               c = 3
              end
             end
             def f():
              global d = 4
              e = 5
             end
            end
            """);
    assertEquals(List.of("a", "b", "c", "d"), List.copyOf(scopes.globals()));
    assertEquals(List.of(), scopes.mainScope().locals());
  }

  @Test
  void aLocalWordHidesTheGlobalInsideTheFunction() {
    String text = "def prog():\n global a = 0\n def myFun():\n  local a = 1\n  b = a\n end\nend\n";
    assertEquals(new Binding.Local("a"), resolve(text, "myFun", "a\n"));
    assertEquals(new Binding.Global("a"), resolve(text, "prog", "a = 0"));
  }

  @Test
  void aFreeNameIsTheGlobalIfThereIsOne() {
    String text = "def prog():\n a = 0\n def myFun():\n  a = 1\n  b = 2\n end\nend\n";
    assertEquals(new Binding.Global("a"), resolve(text, "myFun", "a = 1"));
    assertEquals(new Binding.Local("b"), resolve(text, "myFun", "b = 2"));
    assertEquals(List.of("b"), scope(scopes(text), "myFun").locals());
  }

  @Test
  void aNestedFunctionSkipsTheLocalsAroundIt() {
    String text =
        """
        def prog():
         global a = 0
         def f():
          local a = 1
          def g():
           a = 2
          end
         end
        end
        """;
    assertEquals(new Binding.Local("a"), resolve(text, "f", "a = 1"));
    assertEquals(new Binding.Global("a"), resolve(text, "g", "a = 2"));
  }

  @Test
  void theGlobalMayComeLaterInTheText() {
    String text = "def f():\n return late\nend\ndef prog():\n x = f()\n late = 1\nend\n";
    assertEquals(new Binding.Global("late"), resolve(text, "f", "late"));
  }

  @Test
  void theRightSideOfTheFirstLocalAssignmentSeesTheOuterMeaning() {
    String text =
        """
        def prog():
         a = 0
         def f():
          x = a + 1
          local a = a + 2
          local a = a + 3
         end
        end
        """;
    assertEquals(new Binding.Global("a"), resolve(text, "f", "a + 1"));
    assertEquals(new Binding.Local("a"), resolve(text, "f", "a = a + 2"));
    assertEquals(new Binding.Global("a"), resolve(text, "f", "a + 2"));
    assertEquals(new Binding.Local("a"), resolve(text, "f", "a + 3"));
  }

  @Test
  void parametersAreLocalAndComeFirst() {
    String text =
        "def f(m, n):\n k = 1\n local m = m\n local j = 2\nend\ndef prog():\n m = 1\nend\n";
    assertEquals(new Binding.Local("m"), resolve(text, "f", "m\n"));
    assertEquals(List.of("m", "n", "k", "j"), scope(scopes(text), "f").locals());
  }

  @Test
  void threadsFollowTheRulesOfFunctions() {
    String text =
        "def prog():\n count = 0\n thread t():\n  count = count + 1\n  own = 1\n end\nend\n";
    assertEquals(new Binding.Global("count"), resolve(text, "t", "count = count"));
    assertEquals(List.of("own"), scope(scopes(text), "t").locals());
  }

  @Test
  void aNestedFunctionIsVisibleInItsBodyOnlyAndAlsoBeforeIt() {
    Scopes scopes =
        scopes(
            """
            def f():
             g()
             def g():
              h()
              def h():
              end
             end
            end
            def prog():
             f()
            end
            """);
    assertEquals("g", name(scope(scopes, "f").function("g")));
    assertEquals("f", name(scope(scopes, "h").function("f")));
    assertEquals("prog", name(scope(scopes, "h").function("prog")));
    assertEquals("", name(scope(scopes, "f").function("h")));
    assertEquals("", name(scopes.mainScope().function("g")));
  }

  @Test
  void theProgramsOwnFunctionHasTheMainScope() {
    Scopes scopes = scopes("def prog(a=1):\n x = 1\nend\n");
    assertSame(scopes.mainScope(), scope(scopes, "prog"));
    assertEquals(Set.of("a", "x"), scopes.globals());
  }

  @Test
  void oneInterpretedLineAddsLocalsAfterThoseOfItsCaller() {
    Scopes scopes = scopes("def f(p):\n q = p\nend\ndef prog():\n g = 1\n f(1)\nend\n");
    FunctionScope caller = scope(scopes, "f");
    FunctionScope line = extend(caller, "n = q + g def h(): n = 1 g = 2 end");
    assertEquals(List.of("p", "q", "n"), line.locals());
    assertEquals(new Binding.Local("q"), line.resolve("q", 0));
    assertEquals(new Binding.Global("g"), line.resolve("g", 0));
    FunctionScope next = extend(line, "m = n h()");
    assertEquals(List.of("p", "q", "n", "m"), next.locals());
    FunctionScope inner = line.nested(line.function("h").orElseThrow());
    assertEquals(List.of("n"), inner.locals());
    assertEquals("h", name(next.function("h")));
    assertEquals(List.of("p", "q"), caller.locals());
    assertEquals("", name(caller.function("h")));
  }

  @Test
  void oneInterpretedLineOfTheMainLevelKeepsGlobalsAndMakesNewNamesLocal() {
    FunctionScope main = scopes("def prog():\n g = 1\nend\n").mainScope();
    FunctionScope line = extend(main, "local g = 2 n = 3 global other = 4");
    assertEquals(new Binding.Global("g"), line.resolve("g", 0));
    assertEquals(List.of("n"), line.locals());
    assertEquals(Set.of("g"), line.globals());
  }

  @Test
  void aLaterInterpretedFunctionReplacesTheEarlierOne() {
    FunctionScope main = scopes("def prog():\nend\n").mainScope();
    FunctionScope first = extend(main, "def f(): end");
    FunctionScope second = extend(first, "def f(a): end");
    assertEquals(1, second.function("f").orElseThrow().parameters().size());
    assertEquals(0, first.function("f").orElseThrow().parameters().size());
  }

  @Test
  void whatLinesHaveAddedCanBeTakenToAnotherFunction() {
    Scopes scopes =
        scopes("def f(p):\n q = p\nend\ndef k(q):\n r = 1\nend\ndef prog():\n g = 1\nend\n");
    FunctionScope lines = extend(scope(scopes, "f"), "n = q local g = 2 def h(): end m = 3");
    FunctionScope moved = scope(scopes, "k").with(lines);
    assertEquals(List.of("q", "r", "n", "g", "m"), moved.locals());
    assertEquals("h", name(moved.function("h")));
    assertEquals(List.of("q", "r", "n", "g", "m", "o"), extend(moved, "o = m").locals());
    assertSame(scopes.mainScope(), scopes.mainScope().with(scope(scopes, "f")));
  }

  @Test
  void aDefinitionOfAnotherProgramHasNoScope() {
    Scopes scopes = scopes("def prog():\nend\n");
    Definition other = (Definition) Checks.parse("def prog():\nend\n").statements().getFirst();
    assertThrows(IllegalArgumentException.class, () -> scopes.scope(other));
  }

  private static Scopes scopes(String text) {
    return Scopes.of(ProgramForm.of(Checks.parse(text)));
  }

  private static FunctionScope scope(Scopes scopes, String name) {
    return scopes.definitions().stream()
        .filter(definition -> definition.name().equals(name))
        .map(scopes::scope)
        .findFirst()
        .orElseThrow();
  }

  /** What the name with which {@code place} begins stands for there. */
  private static Binding resolve(String text, String function, String place) {
    String name = place.split("[^a-z]", 2)[0];
    return scope(scopes(text), function).resolve(name, text.indexOf(place));
  }

  private static FunctionScope extend(FunctionScope scope, String line) {
    Script parsed = Checks.parse(line);
    return scope.extendedBy(parsed.statements());
  }

  private static String name(Optional<Definition> definition) {
    return definition.map(Definition::name).orElse("");
  }
}
