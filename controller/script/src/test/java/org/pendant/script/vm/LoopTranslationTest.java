package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;

/** A loop does the same whether it is interpreted, translated or runs directly. */
@Tag("slow")
class LoopTranslationTest {
  private static final String WEIGHTS =
      """
      def weights():
        local values = [1.5, 2.5, 3.5]
        global sum = 0.0
        local i = 0
        while i < 40000:
          local j = 0
          while j < 3:
            sum = sum + values[j] * 0.5
            j = j + 1
          end
          i = i + 1
        end
        textmsg(sum, i)
      end
      """;

  static List<String> loops() {
    return List.of(
        WEIGHTS,
        """
        def numbers_become_floats():
          local a = 1
          global b = 1
          local i = 0
          while i < 12:
            if i == 4:
              a = a * 0.5
            elif i == 7:
              b = b / 2
            end
            a = a + i
            b = b * 3 - a
            textmsg(a, b)
            i = i + 1
          end
          while i < 30:
            b = b * 7
            i = i + 1
            if i % 2 == 0:
              continue
            end
            a = -a
          end
          textmsg(a, b)
          local k = 1
          while True:
            k = k * 3
          end
        end
        """,
        """
        def beyond_the_list():
          local l = [1, 2, 3]
          local sum = 0
          local i = 0
          while True:
            sum = sum + l[i]
            i = i + 1
          end
        end
        """,
        """
        def before_the_list():
          local l = [0.5, 1.5]
          local i = 2
          while True:
            i = i - 1
            l[i] = i
          end
        end
        """,
        """
        def beyond_the_matrix():
          local q = [[1, 2], [3, 4]]
          local i = 0
          local sum = 0
          while True:
            local j = 0
            while j < 2:
              q[i, j] = q[i, j] * 10 + j
              sum = sum + q[i, j]
              j = j + 1
            end
            textmsg(q, sum)
            i = i + 1
          end
        end
        """,
        """
        def lists_change():
          local l = [0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 0, 3, 6, 9, 1, 4, 7]
          local m = l
          global n = [1, 2, 3]
          local i = 0
          while i < 40:
            l[i] = l[i] + i
            n[i % 3] = l[i]
            if i == 20:
              m = l
            elif i == 30:
              n[1] = 0.5
            end
            local k = 0
            while k < 4:
              m[k] = m[k] + l[k] + n[1]
              k = k + 1
            end
            i = i + 1
          end
          textmsg(l, m)
          textmsg(n)
        end
        """,
        """
        def matrices():
          local a = [[1, 2, 3], [4, 5, 6], [7, 8, 9]]
          local b = [[0.5, 0, 0], [0, 0.25, 0], [0, 0, 2]]
          local c = [[0.0, 0, 0], [0, 0, 0], [0, 0, 0]]
          local i = 0
          while i < 3:
            local j = 0
            while j < 3:
              local sum = 0
              local k = 0
              while k < 3:
                sum = sum + a[i, k] * b[k, j]
                k = k + 1
              end
              c[i, j] = sum
              j = j + 1
            end
            i = i + 1
          end
          textmsg(a, c)
          while True:
            a[0, 0] = a[0, 0] + 0.5
            textmsg(a)
            i = i - 1
            a[i, 0] = i
          end
        end
        """,
        """
        def other_elements():
          local p = p[1, 2, 3, 0, 0, 0]
          local flags = [True, False, True]
          local words = ["a", "b"]
          local i = 0
          local sum = 0
          while i < 3:
            sum = sum + p[i]
            p[i] = sum
            if flags[i]:
              flags[i] = False
              sum = sum + 1
            end
            i = i + 1
            if words[i % 2] == "a":
              words[0] = "c"
            end
          end
          textmsg(p, flags)
          textmsg(words, sum)
          while flags[0] == False:
            sum = sum + flags[1]
          end
        end
        """,
        """
        def calls_in_loops():
          global calls = 0
          def half(n):
            if n % 2 == 0:
              return n / 2
            end
            return half(n - 1) + 0.5
          end
          def told(n):
            calls = calls + 1
            return n - calls
          end
          def none():
            calls = calls * 2
          end
          local i = 0
          local sum = 0.0
          while i < 50:
            sum = sum + half(i)
            if i % 10 == 3:
              sum = sum - told(i)
              none()
            end
            i = i + 1
          end
          textmsg(sum, calls)
          while True:
            sum = sum + half(i)
            i = i * 4
          end
        end
        """,
        """
        def globals_in_functions():
          global count = 0
          global scale = 2
          global table = [1, 2, 3, 4]
          global grid = [[0.5, 1], [2, 3]]
          global word = "w"
          def visit(n):
            count = count + 1
            table[n % 4] = table[n % 4] + count
            if count == 60:
              scale = 0.5
            end
            if n <= 0:
              return count * scale
            end
            local below = visit(n - 2)
            grid[n % 2, 0] = below
            return below + grid[n % 2, 0] * scale
          end
          def none():
            count = -count
          end
          def other(n):
            if n > 30:
              textmsg(word, n)
              word = word + "x"
            end
            return n + table[4 - n % 4]
          end
          local i = 0
          local sum = 0
          while i < 24:
            sum = sum + visit(i % 5)
            none()
            scale = scale + 1
            none()
            i = i + 1
          end
          textmsg(sum, count)
          textmsg(table, grid)
          while True:
            count = count + 1
            sum = sum + other(count)
          end
        end
        """,
        """
        def returns_from_loops():
          def first(l, x):
            local i = 0
            while i < 5:
              local k = 0
              while k < i:
                if l[k] * l[i] == x:
                  return l[i]
                end
                k = k + 1
              end
              i = i + 1
            end
          end
          local x = 0
          while x < 40:
            textmsg(first([2, 3, 5, 7, 11], x))
            x = x + 3
          end
        end
        """,
        """
        def no_value_yet():
          local i = 0
          while i < 6:
            if i > 2:
              local a = i
            end
            if i > 3:
              textmsg(a)
            end
            i = i + 1
          end
          while True:
            i = i - 1
            if i < 3:
              i = b
            else:
              local b = 1
            end
          end
        end
        """,
        """
        def others_change_globals():
          global a = 0
          global l = [0, 0]
          thread other():
            while True:
              a = a + 1
              l[1] = l[1] + a
              if a % 7 == 0:
                l = [a, 0.5]
              end
              sync()
            end
          end
          local h = run other()
          local k = 0
          while a < 12:
            l[0] = l[0] + a
            k = k + 1
            if k % 20000 == 0:
              textmsg(a, l)
            end
          end
          kill h
          textmsg(l)
        end
        """);
  }

  @ParameterizedTest
  @MethodSource("loops")
  void loopsDoTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, List.of());
    TranslationRuns.Shown expected = runs.interpreted();
    assertEquals(expected, runs.translated());
    assertEquals(expected, runs.mixed(new Random(1)));
    assertEquals(runs.covered().interpreted(), runs.covered().translated());
  }

  @ParameterizedTest
  @MethodSource("loops")
  void loopsArePreemptedBeforeTheSameInstructions(String script) {
    for (int seed = 0; seed < 20; seed++) {
      TranslationRuns runs = new TranslationRuns(script, List.of()).inShortSlices(seed);
      assertEquals(runs.interpreted(), runs.translated(), "seed " + seed);
    }
  }

  @Test
  void randomLoopsDoTheSameInShortSlices() {
    int valid = 0;
    for (int seed = 0; valid < 100 * Integer.getInteger("test.cases", 1); seed++) {
      String script = new RandomScript(new Random(1_000_000 + seed)).text();
      TranslationRuns runs = new TranslationRuns(script, List.of()).inShortSlices(seed);
      if (runs.valid()) {
        valid++;
        assertEquals(runs.interpreted(), runs.translated(), () -> script);
      }
    }
  }

  @Test
  void aLoopOfTheMainProgramRunsDirectlyAndABreakpointHoldsIt() {
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    Program program = fixture.compile(WEIGHTS);
    Debugger debugger = new Debugger(fixture.machine, _ -> {});
    fixture.machine.start(program);
    fixture.advance(1);
    assertTrue(runsDirectly(fixture));
    assertFalse(fixture.machine.held());
    debugger.set(Breakpoint.at(8));
    fixture.advance(1);
    assertTrue(fixture.machine.held());
    assertEquals(8, fixture.machine.line());
    debugger.removeBreakpoints();
    debugger.resume();
    fixture.finish();
    assertEquals(List.of("15000040000"), fixture.messages);
  }

  @Test
  void aLoopOfAFunctionTooLargeForATranslationRunsDirectly() {
    String much =
        IntStream.range(0, 700)
            .mapToObj(i -> "  x = x + " + i + "\n")
            .collect(Collectors.joining());
    String script = WEIGHTS.replace("def weights():", "def weights():\n  local x = 1\n" + much);
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    Program program = fixture.compile(script);
    fixture.machine.start(program);
    fixture.advance(1);
    assertTrue(program.tables().functions().getFirst().untranslatable);
    assertTrue(runsDirectly(fixture));
    loopsDoTheSame(script);
    loopsArePreemptedBeforeTheSameInstructions(script);
  }

  @Test
  void aLoopWithinOneThatIsTooLongRunsDirectly() {
    String much =
        IntStream.range(0, 200).mapToObj(i -> "x = x + " + i + "\n").collect(Collectors.joining());
    String script =
        WEIGHTS
            .replace("while i < 40000:", "local x = 1\nwhile i < 60:\n" + much)
            .replace("j < 3", "j < 3000")
            .replace("[j]", "[j % 3]");
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    fixture.machine.start(fixture.compile(script));
    fixture.advance(1);
    assertTrue(runsDirectly(fixture));
    loopsDoTheSame(script);
    loopsArePreemptedBeforeTheSameInstructions(script);
  }

  @Test
  void aLoopCompiledForCoverageRunsDirectly() {
    MachineFixture fixture = new MachineFixture(Translation.ALWAYS);
    fixture.machine.start(fixture.compileCovered(WEIGHTS));
    fixture.advance(1);
    assertTrue(runsDirectly(fixture));
  }

  /** Whether there is code for the loop that the main thread is in. */
  private static boolean runsDirectly(MachineFixture fixture) {
    ProgramRun run = fixture.machine.run().orElseThrow();
    ScriptThread main = run.main();
    ScriptFunction function = main.functions[main.depth - 1];
    return IntStream.range(0, function.instructions().length)
        .mapToObj(pc -> function.loop(pc, run.registers(), main.base()))
        .anyMatch(entry -> entry != null && entry.ready());
  }

  @Test
  void anInnerLoopBelongsToTheOutermostOne() {
    MachineFixture fixture = new MachineFixture(Translation.NEVER);
    Program program = fixture.compile(WEIGHTS);
    ScriptFunction main = program.tables().functions().getFirst();
    int inner =
        IntStream.range(0, main.instructions().length)
            .map(pc -> LoopInstructions.backTo(main.instructions()[pc], pc))
            .filter(target -> target >= 0)
            .max()
            .orElseThrow();
    LoopRegion region = new LoopRegion(main, program.tables(), inner);
    assertTrue(region.first() < inner);
    assertEquals(
        Set.of("values", "sum", "i", "j"),
        Arrays.stream(region.globals())
            .mapToObj(program.tables().staticNames()::get)
            .collect(Collectors.toSet()));
  }
}
