package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

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
  private static final String FIBONACCI =
      """
      def prog():
        def fib(n):
          if n < 2:
            return n
          end
          return fib(n - 1) + fib(n - 2)
        end
        textmsg(fib(24))
      end
      """;

  static List<String> scripts() {
    return List.of(
        FIBONACCI,
        """
        def arithmetic():
          local i = 7
          local f = 2.5
          textmsg(i + 2, i - 9)
          textmsg(i * f, i / 2)
          textmsg(i % 4, -i)
          textmsg(-f, -(i - 7))
          textmsg(0 * -1, 0.0 * -1)
          textmsg(-7 % 3, 7.5 % 2)
          textmsg(i == 7.0, i != 7)
          textmsg(i < f, i <= 7)
          textmsg(i > f, not (i >= 8))
          textmsg(True == 1, False == "x")
          textmsg(True xor i < f, None == None)
          local b = i > 3 and f < 3 or i == 0
          textmsg(b, not b)
          local s = "a"
          s = s + "b"
          textmsg(s + "c", s == "ab")
          local n = f
          n = 3
          textmsg(n, [i, f])
          global g = 1
          while g < 1000:
            g = g * 3
            g = g - 1
          end
          textmsg(g)
        end
        """,
        """
        def overflow():
          local i = 1
          while i > 0:
            i = i * 5 + 1
            textmsg(i)
          end
        end
        """,
        """
        def division(): local x = 0
          while x < 3:
            textmsg(6 / (2 - x))
            x = x + 1
          end
        end
        """,
        """
        def kinds():
          def f(y):
            local x = 1
            textmsg(x + 1)
            x = y
            return x
          end
          textmsg(f(1.5))
          textmsg(f(True))
        end
        """,
        """
        def ordered():
          local l = [1, 2, 3]
          def f(a, b):
            return a < b
          end
          textmsg(f(1, 2), f(2.5, 2))
          textmsg(f(1, l))
        end
        """,
        """
        def condition():
          def f(a):
            if a:
              return 1
            end
          end
          textmsg(f(True), f(0))
          textmsg(f("x"), f(""))
          textmsg(f([1]))
        end
        """,
        """
        def missing():
          def f(a, b):
            return a
          end
          def g(n):
            if n == 3:
              return f(n)
            end
            return f(n, 0)
          end
          local i = 0
          while True:
            textmsg(g(i))
            i = i + 1
          end
        end
        """,
        """
        def defaults():
          global calls = 0
          def next(n=calls):
            calls = n + 1
            return calls
          end
          def f(a=next(), b=a * 2, c=[a, b]):
            c[0] = b
            return a + c[0] + c[1]
          end
          local i = 0
          while i < 20000:
            i = i + f(1)
            i = i + f(b=next())
          end
          textmsg(i, calls)
          textmsg(f("x"))
        end
        """,
        """
        def texts():
          def f(x):
            return not x
          end
          local s = ""
          local i = 0
          local counted = 0
          while i < 20 and (i < 10 or s):
            if not s:
              s = "a"
            elif s and "" or not (s xor ""):
              counted = -1
            end
            if s:
              counted = counted + 1
              s = ""
            end
            local kept = not s
            i = i + 1
          end
          textmsg(counted, kept)
          textmsg(not f([1]))
        end
        """,
        """
        def unassigned():
          def f(a):
            if a > 1:
              local x = a
            end
            return x + 1
          end
          textmsg(f(2))
          textmsg(f(1))
        end
        """,
        """
        def elements():
          def fill(m, rows, columns, x):
            local r = 0
            while r < rows:
              local c = 0
              while c < columns:
                m[r, c] = m[r, c] + x * c
                c = c + 1
              end
              r = r + 1
            end
            return m
          end
          local small = [[1, 2], [3, 4]]
          textmsg(fill(small, 2, 2, 3), small)
          textmsg(fill(small, 2, 2, 0.5), fill([[1.5, 2], [3, 4]], 2, 2, 1))
          local row = [1, 2, 3, 4, 5, 6, 7]
          local large = [row, row, row, row, row, row, row]
          local same = large
          large[6, 6] = 8
          textmsg(fill(large, 7, 7, 1), same)
          textmsg(fill(large, 7, 8, 1))
        end
        """,
        """
        def element_of_another_kind():
          local m = [[1, 2], [3, 4]]
          local i = 0
          while True:
            m[i, 1] = 5.5
            m[1, i] = i > 0
            i = i + 1
          end
        end
        """,
        """
        def components():
          local p = p[1, 2, 3, 0.1, 0.2, 0.3]
          local q = p
          local x = 1
          local i = 0
          while i < 6:
            q[i] = p[i] * 2
            q[5 - i] = i
            x = q[i]
            i = i + 1
          end
          textmsg(p, q)
          textmsg(x, p[2.0])
          q[2] = True
        end
        """,
        """
        def components_into_another_type():
          def keep(flag, p):
            flag = p[5]
            return flag
          end
          local p = p[1, 2, 3, 0.1, 0.2, 0.3]
          textmsg(keep(1, p), keep(2.5, p))
          textmsg(keep(False, p))
        end
        """,
        """
        def components_outside():
          local p = p[1, 2, 3, 0.1, 0.2, 0.3]
          local i = 4
          while True:
            p[i] = p[i] + 1
            i = i + 1
          end
        end
        """,
        """
        def lists():
          local l = [1, 2, 3]
          local m = [1.5, 2.5]
          local i = 0
          while i < 3:
            l[i] = l[i] * 2
            i = i + 1
          end
          local k = l
          k[0] = 9.5
          m[1] = l[2]
          l[1] = m[0]
          textmsg(l, k)
          textmsg(m)
          local a = [[1, 2], [3, 4]]
          a[1, 0] = 7
          textmsg(a * a, a[0])
          local t = ["a", "b"]
          t[1] = t[0] + "c"
          textmsg(t, t[1])
          local p = p[1, 2, 3, 0, 0, 0]
          p[2] = p[0] * 4
          textmsg(p)
          local s = struct(a = 1, b = [2, 3])
          s.a = s.b[1]
          s.b[0] = 8
          textmsg(s)
          textmsg(l[i])
        end
        """,
        """
        def elements():
          def trace(m, n):
            local sum = 0
            local i = 0
            while i < n:
              sum = sum + m[i, i] * m[i, 1]
              i = i + 1
            end
            return sum
          end
          local ints = [[1, 2], [3, 4]]
          local floats = [[1.5, 2.5], [3.5, 4.5]]
          ints[0, 1] = 7
          textmsg(trace(ints, 2), trace(floats, 2))
          floats[1, 1] = ints[0, 1]
          textmsg(floats, [1, 2][trace([[1, 1], [0, 0]], 2)])
          textmsg(trace(ints, 3))
        end
        """,
        """
        def wrong_element():
          local l = [1, 2]
          l[0] = 3
          l[1] = True
        end
        """,
        """
        def float_index():
          local l = [1, 2, 3]
          textmsg(l[1.0])
          textmsg(l[0.5])
        end
        """,
        """
        def threads():
          global n = 0
          thread counter():
            local i = 0
            while True:
              n = n + 1
              i = i + 1
              if i % 3 == 0:
                sync()
              end
            end
          end
          thread once():
            n = n + 100
            return 5
          end
          local a = run counter()
          local b = run once()
          join b
          sync()
          sync()
          kill a
          textmsg(n, a)
          enter_critical
          n = 0
          while n < 120000:
            n = n + 1
          end
          exit_critical
          textmsg(n)
          join a
        end
        """,
        """
        def crowd():
          global turns = 0
          thread worker():
            local i = 0
            while i < 30000:
              i = i + 1
              turns = turns + i % 7
            end
          end
          local i = 0
          while i < 12:
            local h = run worker()
            i = i + 1
          end
          join h
          textmsg(turns)
        end
        """,
        """
        def suicide():
          thread t():
            sync()
            kill 1
            textmsg("never")
          end
          local h = run t()
          sync()
          sync()
          sync()
          textmsg("alive")
        end
        """,
        """
        def too_deep():
          def down(n):
            return down(n + 1) + 1
          end
          textmsg(down(0))
        end
        """,
        """
        def deep():
          def down(n):
            if n == 0:
              sync()
              return 0
            end
            local x = [n, 1.5]
            return down(n - 1) + x[1]
          end
          local i = 0
          while i < 3:
            textmsg(down(900))
            textmsg(down(100 + 20 * i))
            i = i + 1
          end
        end
        """,
        """
        def failing_inside():
          def inner(l, i):
            return l[i] + 1
          end
          def outer(n):
            local s = 0

            while True:
              s = s + inner([1, 2, 3], n)
              n = n + 1
            end
          end
          textmsg(outer(0))
        end
        """,
        """
        def nested_loops():
          local s = 0.5
          local i = 0
          while i < 700:
            local j = 0
            while j <= 700:
              if j == 350:
                j = j + 2
                continue
              end
              s = s + i * j
              j = j + 1
              if j > 690:
                break
              end
            end
            i = i + 1
          end
          textmsg(s)
        end
        """,
        """
        def calls_exhaust():
          def nothing(x, y=[1, 2]):
            return y
          end
          local i = 0
          while i < 90000:
            nothing(i)
            i = i + 1
          end
          textmsg(i, nothing(1))
        end
        """,
        """
        def halting():
          local i = 0
          while True:
            i = i + 1
            if i == 70000:
              textmsg(i)
              halt
            end
          end
        end
        """,
        """
        def pausing():
          textmsg("before")
          pause
          textmsg("after")
        end
        """,
        """
        def interpreting():
          global g = 1
          local x = 2.5
          local y = [1, 2]
          def twice(a):
            return 2 * a
          end
          textmsg("in")
          interpreter_mode()
          textmsg(g, x)
          textmsg(y)
          x = x + 1
          textmsg(x)
        end
        """);
  }

  /** Functions that call each other with plain values, which other code calls again and again. */
  static List<String> calls() {
    return List.of(
        FIBONACCI,
        """
        def kinds_change():
          def f(n, x):
            if n <= 0:
              return x
            end
            local half = x / 2
            local y = f(n - 1, half) + f(n - 2, x * n)
            if n % 3 == 0:
              y = y + 1
            end
            return y - half
          end
          local i = 0
          while i < 12:
            textmsg(f(i, i), f(i, i + 0.5))
            i = i + 1
          end
          textmsg(f(4, True))
        end
        """,
        """
        def overflow_inside():
          def product(n):
            if n < 2:
              return 1
            end
            return product(n - 1) * n
          end
          local i = 0
          while True:
            textmsg(product(i))
            i = i + 1
          end
        end
        """,
        """
        def division_inside():
          def g(n):
            return 12 / n + 7 % n
          end
          def f(n):
            local sum = 0
            local k = 5
            while k >= n:
              sum = sum + g(k)
              k = k - 1
            end
            return sum
          end
          local i = 3
          while True:
            textmsg(f(i), -f(i))
            i = i - 1
          end
        end
        """,
        """
        def not_a_number():
          def big(n):
            if n == 0:
              return 1.5
            end
            local b = big(n - 1) * 1000.0
            return b * b
          end
          def f(n):
            local x = big(n)
            local y = x - x
            return y
          end
          local i = 0
          while i < 12:
            textmsg(f(i), f(i) == f(i))
            textmsg(f(i) < 1, not f(i))
            i = i + 1
          end
        end
        """,
        """
        def now_and_then():
          def none(n):
            if n % 2 == 0:
              return n
            end
          end
          def odd(n):
            if n == 0:
              return False
            end
            return even(n - 1)
          end
          def even(n):
            if n == 0:
              return True
            end
            return odd(n - 1)
          end
          def mixed(n):
            if n % 3 == 0:
              return n
            elif n % 3 == 1:
              return n * 0.5
            end
            local b = odd(n)
            if b:
              return -n
            end
            return even(n)
          end
          local i = 0
          while i < 40:
            textmsg(none(i), odd(i))
            textmsg(mixed(i), even(i) == odd(i))
            i = i + 1
          end
          while True:
            textmsg(mixed(i) + 1)
            i = i + 1
          end
        end
        """,
        """
        def left_out():
          def f(a, b=a * 2, c=7):
            if a > 5:
              local x = a - b
            end
            while a > c:
              a = a - 1
              local y = a + b
            end
            if a == 6:
              return x + y
            end
            return b + c
          end
          local i = 0
          while True:
            textmsg(f(i), f(i, 3.5))
            textmsg(f(i, c=2.5), f(a=i, c=i))
            i = i + 1
          end
        end
        """,
        """
        def of_either_type():
          def power(n):
            local s = 1
            if n % 2 == 0:
              s = 0.5
            end
            local k = 0
            while k < n:
              s = s * -7
              k = k + 1
            end
            return -s + 2
          end
          local i = 0
          while True:
            textmsg(power(i), power(i + 1) < power(i))
            i = i + 1
          end
        end
        """,
        """
        def deep_and_back():
          def down(n, x):
            if n <= 0:
              return x
            end
            return down(n - 1, x + 0.25) - 1
          end
          local i = 1
          while True:
            textmsg(down(i, 0), down(i, 0.5))
            i = i * 2
          end
        end
        """,
        """
        def outside():
          global calls = 0
          def leaf(n):
            calls = calls + 1
            return n * 2
          end
          def tell(n):
            if n == 3:
              textmsg("three", calls)
            end
            if n == 5:
              sync()
            end
            return leaf(n)
          end
          def sum(n):
            local s = 0
            local k = 0
            while k < n:
              s = s + tell(k) + leaf(k)
              k = k + 1
            end
            return s
          end
          local i = 0
          while i < 9:
            textmsg(sum(i), calls)
            i = i + 1
          end
        end
        """,
        """
        def two_threads():
          global a = 0
          global b = 0
          def fib(n):
            if n < 2:
              return n
            end
            return fib(n - 1) + fib(n - 2)
          end
          thread one():
            local i = 0
            while i < 9:
              a = a + fib(i)
              i = i + 1
            end
          end
          thread two():
            local i = 0
            while i < 9:
              b = b + fib(i) * 0.5
              i = i + 1
            end
          end
          local h = run one()
          local k = run two()
          join h
          join k
          textmsg(a, b)
        end
        """);
  }

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
  @MethodSource("calls")
  void directCallsDoTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, List.of());
    assertEquals(runs.interpreted(), runs.translated());
    assertEquals(runs.interpreted(), runs.mixed(new Random(1)));
  }

  @ParameterizedTest
  @MethodSource({"calls", "scripts"})
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
  @MethodSource("scripts")
  void aTranslatedProgramDoesTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, LINES);
    assertEquals(runs.interpreted(), runs.translated());
  }

  @ParameterizedTest
  @MethodSource("scripts")
  void aProgramCompiledForCoverageDoesTheSame(String script) {
    TranslationRuns runs = new TranslationRuns(script, LINES);
    TranslationRuns.Shown covered = runs.covered().interpreted();
    assertEquals(runs.interpreted().unmarked(), covered.unmarked());
    assertEquals(covered, runs.covered().translated());
    assertEquals(covered, runs.covered().mixed(new Random(1)));
  }

  @ParameterizedTest
  @MethodSource("scripts")
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
