package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.script.vm.TranslatedScripts.FIBONACCI;

import java.util.List;
import java.util.Random;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.Registers;

/** A program does the same whether its functions are interpreted or translated. */
@Tag("slow")
class TranslationTest {
  /** Expressions that are over leave values in registers, which calls may write over or not. */
  @Test
  void everyFormTakesTheSameMemory() {
    String script =
        """
        def memory():
          def f(a, b):
            return (a + b) * (a - b) + (a * b + (a + (b + (a - (b - 1)))))
          end
          local text = "0123456789"
          local i = 0
          while i < 16:
            text = text + text
            i = i + 1
          end
          local n = 0
          i = 0
          while i < 40:
            n = n + f(i, 2)
            local l = ["_" + text, "a" + text, "b" + text, "c" + text, "d" + text, "e" + text, "f" + text]
            i = i + 1
          end
          textmsg(n, i)
        end
        """;
    TranslationRuns runs = new TranslationRuns(script, List.of());
    assertEquals(runs.interpreted().threads(), runs.translated().threads());
  }

  @ParameterizedTest
  @MethodSource("org.pendant.script.vm.TranslatedCalls#calls")
  void directCallsDoTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, List.of());
    assertEquals(runs.interpreted(), runs.translated());
    assertEquals(runs.interpreted(), runs.mixed(new Random(1)));
  }

  @ParameterizedTest
  @MethodSource({
    "org.pendant.script.vm.TranslatedCalls#calls",
    "org.pendant.script.vm.TranslatedScripts#scripts"
  })
  void everyFormIsPreemptedBeforeTheSameInstructions(String script) {
    for (int seed = 0; seed < 5; seed++) {
      TranslationRuns runs = new TranslationRuns(script, LINES).inShortSlices(seed);
      TranslationRuns.Shown expected = runs.interpreted();
      assertEquals(expected, runs.translated(), "seed " + seed);
      assertEquals(expected, runs.mixed(new Random(seed)), "seed " + seed);
    }
  }

  private static final List<String> LINES =
      List.of(
          "x = x + 1",
          "g = twice(x)",
          "local z = 1",
          "def thrice(a): return 3 * a end",
          "while z < 70000: z = z + 1 end",
          "y[1] = thrice(z)",
          "h = run nothing()",
          "end_interpreter()");

  @ParameterizedTest
  @MethodSource("org.pendant.script.vm.TranslatedScripts#scripts")
  void aTranslatedProgramDoesTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, LINES);
    assertEquals(runs.interpreted(), runs.translated());
  }

  @ParameterizedTest
  @MethodSource("org.pendant.script.vm.TranslatedScripts#scripts")
  void aProgramCompiledForCoverageDoesTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, LINES);
    TranslationRuns.Shown covered = runs.covered().interpreted();
    assertEquals(runs.interpreted().unmarked(), covered.unmarked());
    assertEquals(covered, runs.covered().translated());
    assertEquals(covered, runs.covered().mixed(new Random(1)));
  }

  @ParameterizedTest
  @MethodSource("org.pendant.script.vm.TranslatedScripts#scripts")
  void bothFormsTakeOverFromEachOther(String script) {
    TranslationRuns runs = new TranslationRuns(script, LINES);
    TranslationRuns.Shown expected = runs.interpreted();
    for (int seed = 0; seed < 10; seed++) {
      assertEquals(expected, runs.mixed(new Random(seed)), "seed " + seed);
    }
  }

  @Test
  void randomProgramsDoTheSameInEveryForm() {
    int valid = 0;
    for (int seed = 0; valid < 80 * Integer.getInteger("test.cases", 1); seed++) {
      String script = new RandomScript(new Random(seed)).text();
      TranslationRuns runs = new TranslationRuns(script, List.of());
      if (!runs.valid()) {
        continue;
      }
      valid++;
      TranslationRuns.Shown expected = runs.interpreted();
      assertEquals(expected, runs.translated(), () -> script);
      assertEquals(expected, runs.mixed(new Random(seed)), () -> script);
      TranslationRuns shortened = runs.inShortSlices(seed);
      assertEquals(shortened.interpreted(), shortened.translated(), () -> script);
      TranslationRuns.Shown covered = runs.covered().interpreted();
      assertEquals(expected.unmarked(), covered.unmarked(), () -> script);
      assertEquals(covered, runs.covered().translated(), () -> script);
      assertEquals(covered, runs.covered().mixed(new Random(seed)), () -> script);
    }
  }

  @Test
  void aProgramThatRunsWithoutTranslationIgnoresOneThatIsThere() {
    MachineFixture translating = new MachineFixture(Translation.ALWAYS);
    Program program = translating.compile(FIBONACCI);
    ScriptFunction fib = program.tables().functions().get(1);
    assertNull(fib.translated());
    translating.machine.start(program);
    translating.finish();
    assertNotNull(fib.translated());
    MachineFixture interpreting = new MachineFixture(Translation.NEVER);
    interpreting.machine.start(program);
    interpreting.finish();
    assertEquals(List.of("46368", "46368"), translating.messages);
    assertEquals(translating.frames, interpreting.frames);
  }

  @Test
  void aBreakpointHoldsAProgramWhoseFunctionsAreCalledDirectly() {
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    Program program = fixture.compile(FIBONACCI);
    Debugger debugger = new Debugger(fixture.machine, _ -> {});
    fixture.machine.start(program);
    fixture.advance(1);
    ScriptFunction fib = program.tables().functions().get(1);
    assertNotNull(
        fib.direct(
                DirectEntry.key(0, 0, Registers.INT),
                fixture.machine.run().orElseThrow().registers())
            .code());
    assertFalse(fixture.machine.held());
    debugger.set(Breakpoint.at(4));
    fixture.advance(1);
    assertTrue(fixture.machine.held());
    assertEquals(4, fixture.machine.line());
    debugger.removeBreakpoints();
    debugger.resume();
    fixture.finish();
    assertEquals(List.of("46368"), fixture.messages);
  }

  @Test
  void aFunctionTooLargeForTheJvmStaysInterpreted() {
    String sum =
        IntStream.range(0, 300).mapToObj(i -> "x * " + i).collect(Collectors.joining(" + "));
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    Program program = fixture.compile("def prog():", "local x = 2", "textmsg(" + sum + ")", "end");
    fixture.machine.start(program);
    fixture.finish();
    assertEquals(List.of("89700"), fixture.messages);
    assertTrue(program.tables().functions().getFirst().untranslatable);
  }

  @Test
  void nothingIsTranslatedBeforeItIsHot() {
    MachineFixture fixture = new MachineFixture();
    Program program = fixture.compile("def prog():", "local x = 2", "textmsg(x)", "end");
    fixture.machine.start(program);
    fixture.finish();
    assertNull(program.tables().functions().getFirst().translated());
    assertFalse(program.tables().functions().getFirst().untranslatable);
  }
}
