package org.pendant.script.vm;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageSite;
import org.pendant.script.coverage.CoverageSite.Kind;

/** A program that was compiled for coverage tells what it has reached. */
class CoverageTest {
  /** What was reached, in both forms alike. */
  private static Coverage run(String text) {
    Coverage interpreted = run(text, Translation.NEVER);
    assertEquals(told(interpreted), told(run(text, Translation.ALWAYS)));
    return interpreted;
  }

  private static Coverage run(String text, Translation translation) {
    MachineFixture fixture = new MachineFixture(translation);
    fixture.machine.start(fixture.compileCovered(text));
    fixture.advance(50);
    return fixture.machine.coverage().orElseThrow();
  }

  /** Each place with what was reached: {@code 3 branch a == 1: F-}. */
  private static List<String> told(Coverage coverage) {
    return told(coverage, Kind.values());
  }

  private static List<String> told(Coverage coverage, Kind... kinds) {
    List<String> told = new ArrayList<>();
    for (CoverageSite site : coverage.map().sites()) {
      if (List.of(kinds).contains(site.kind())) {
        told.add(
            site.line()
                + " "
                + site.kind().name().toLowerCase(Locale.ROOT)
                + " "
                + coverage.map().source().text(site.range())
                + ": "
                + ways(coverage, site));
      }
    }
    return told;
  }

  private static String ways(Coverage coverage, CoverageSite site) {
    if (!site.kind().twoWay()) {
      return coverage.reached(site) ? "yes" : "no";
    }
    return (coverage.reached(site, false) ? "F" : "-") + (coverage.reached(site, true) ? "T" : "-");
  }

  @Test
  void statementsAreReachedOneByOneUpToTheOneThatFails() {
    assertEquals(
        List.of(
            "1 function prog: yes",
            "2 statement a = 1: yes",
            "3 statement b = 1 / (a - 1): yes",
            "4 statement textmsg(b): no"),
        told(run("def prog():\n  a = 1\n  b = 1 / (a - 1)\n  textmsg(b)\nend\n")));
  }

  @Test
  void eitherWayOfABranchIsToldAndAnElifIsAStatement() {
    String text =
        """
        def prog():
          def sign(x):
            if x < 0:
              return -1
            elif x == 0:
              return 0
            else:
              return 1
            end
          end
          sign(-1)
          sign(5)
        end
        """;
    assertEquals(
        List.of(
            "1 function prog: yes",
            "2 function sign: yes",
            "3 statement if x < 0: yes",
            "3 branch x < 0: FT",
            "4 statement return -1: yes",
            "5 statement elif x == 0: yes",
            "5 branch x == 0: F-",
            "6 statement return 0: no",
            "8 statement return 1: yes",
            "11 statement sign(-1): yes",
            "12 statement sign(5): yes"),
        told(run(text)));
  }

  @Test
  void statementsThatAreNeverLeftAreReached() {
    String text =
        """
        def prog():
          thread t():
            a = 1
            frames(100)
            a = 2
          end
          def inner():
            b = 1
            frames(200)
            b = 2
          end
          h = run t()
          if h > 0:
            frames(2)
            kill h
            inner()
            c = 3
          end
        end
        """;
    assertEquals(
        List.of(
            "3 statement a = 1: yes",
            "4 statement frames(100): yes",
            "5 statement a = 2: no",
            "8 statement b = 1: yes",
            "9 statement frames(200): yes",
            "10 statement b = 2: no",
            "12 statement h = run t(): yes",
            "13 statement if h > 0: yes",
            "14 statement frames(2): yes",
            "15 statement kill h: yes",
            "16 statement inner(): yes",
            "17 statement c = 3: no"),
        told(run(text), Kind.STATEMENT));
    assertEquals(List.of("13 branch h > 0: -T"), told(run(text), Kind.BRANCH));
  }

  @Test
  void aBlockWhoseFirstStatementFailsIsEntered() {
    String text =
        """
        def prog():
          a = 1
          if a == 1:
            b = 1 / (a - 1)
            textmsg(b)
          end
        end
        """;
    assertEquals(List.of("3 branch a == 1: -T"), told(run(text), Kind.BRANCH));
    assertEquals(
        List.of("4 statement b = 1 / (a - 1): yes", "5 statement textmsg(b): no"),
        told(run(text), Kind.STATEMENT).subList(2, 4));
  }

  @Test
  void branchWithoutElseIsToldAsNotTaken() {
    assertEquals(
        List.of("3 branch a == 1: -T", "6 branch a == 2: F-"),
        told(
            run(
                """
                def prog():
                  a = 1
                  if a == 1:
                    a = 1
                  end
                  if a == 2:
                    a = 1
                  end
                end
                """),
            Kind.BRANCH));
  }

  @Test
  void operandsOfAndAndOrAreToldEachWithBothTruths() {
    String text =
        """
        def prog():
          def both(a, b):
            if a > 0 and b > 0:
              return 1
            end
            return 0
          end
          def any(a, b, c):
            x = a or not b or (b and c)
            return x
          end
          both(1, 0)
          both(1, 1)
          any(False, True, False)
          any(False, False, True)
        end
        """;
    assertEquals(
        List.of(
            "3 branch a > 0 and b > 0: FT",
            "3 condition a > 0: -T",
            "3 condition b > 0: FT",
            "9 condition a: F-",
            "9 condition not b: FT",
            "9 condition b: -T",
            "9 condition c: F-"),
        told(run(text), Kind.BRANCH, Kind.CONDITION));
  }

  @Test
  void aLoopIsEnteredLeftAndBrokenOutOf() {
    String text =
        """
        def prog():
          i = 0
          while i < 3:
            i = i + 1
          end
          while i != 9:
            i = 9
            if i == 9:
              break
            end
            continue
          end
          while i == 0:
            i = 1
          end
          while i > 0 and i < 100:
            i = i * 2
            if i > 20:
              continue
            end
          end
        end
        """;
    assertEquals(
        List.of(
            "3 branch i < 3: FT",
            "6 branch i != 9: -T",
            "8 branch i == 9: -T",
            "13 branch i == 0: F-",
            "16 branch i > 0 and i < 100: FT",
            "16 condition i > 0: -T",
            "16 condition i < 100: FT",
            "18 branch i > 20: FT"),
        told(run(text), Kind.BRANCH, Kind.CONDITION));
    assertTrue(told(run(text)).contains("11 statement continue: no"));
    assertTrue(told(run(text)).contains("19 statement continue: yes"));
  }

  @Test
  void constantsDecideNothing() {
    String text =
        """
        def prog():
          while True:
            sync()
            if not False:
              sync()
            end
          end
        end
        """;
    assertEquals(List.of(), told(run(text), Kind.BRANCH, Kind.CONDITION));
    assertEquals(
        List.of(
            "2 statement while True: yes",
            "3 statement sync(): yes",
            "4 statement if not False: yes",
            "5 statement sync(): yes"),
        told(run(text), Kind.STATEMENT));
  }

  @Test
  void functionsAndThreadsAreReachedWhenTheirFirstStatementBegins() {
    String text =
        """
        def prog():
          thread watch():
            while True:
              sync()
            end
          end
          thread never():
            sync()
          end
          def called(x):
            def inner():
              return 1
            end
            return x + inner()
          end
          def uncalled():
            return 1
          end
          handle = run watch()
          called(1)
          sync()
          kill handle
        end
        """;
    assertEquals(
        List.of(
            "1 function prog: yes",
            "2 function watch: yes",
            "7 function never: no",
            "10 function called: yes",
            "11 function inner: yes",
            "16 function uncalled: no"),
        told(run(text), Kind.FUNCTION));
  }

  @Test
  void whatFollowsAReturnIsNeverReached() {
    assertEquals(
        List.of("3 statement return 1: yes", "4 statement textmsg(1): no", "6 statement f(): yes"),
        told(
            run("def prog():\n  def f():\n    return 1\n    textmsg(1)\n  end\n  f()\nend\n"),
            Kind.STATEMENT));
  }

  @Test
  void aNameThatStandsAloneIsAStatement() {
    assertEquals(
        List.of(
            "2 statement x = 1: yes",
            "3 statement x: yes",
            "4 statement if x == 2: yes",
            "5 statement x: no"),
        told(run("def prog():\n  x = 1\n  x\n  if x == 2:\n    x\n  end\nend\n"), Kind.STATEMENT));
  }

  @Test
  void sitesOfAFragmentBelongToNoFunctionUnlessTheyStandInOne() {
    Coverage coverage = run("x = 1\ndef f():\n  textmsg(x)\nend\nf()\n");
    assertEquals(
        List.of("", "f", "f", ""),
        coverage.map().sites().stream().map(CoverageSite::function).toList());
  }

  @Test
  void theNextRunStartsWithoutMarks() {
    MachineFixture fixture = new MachineFixture();
    Program program = fixture.compileCovered("def prog():\n  frames(2)\n  textmsg(1)\nend\n");
    fixture.machine.start(program);
    fixture.advance(5);
    Coverage first = fixture.machine.coverage().orElseThrow();
    fixture.machine.start(program);
    fixture.advance(1);
    assertEquals("yes", ways(first, first.map().sites().getLast()));
    Coverage second = fixture.machine.coverage().orElseThrow();
    assertEquals("no", ways(second, second.map().sites().getLast()));
  }

  @Test
  void aProgramWithoutCoverageHasNoMarksAndTheInstructionsItAlwaysHad() {
    String text = "def prog():\n  i = 0\n  while i < 3 or i == 7:\n    i = i + 1\n  end\nend\n";
    MachineFixture fixture = new MachineFixture();
    Program plain = fixture.compile(text);
    fixture.machine.start(plain);
    assertTrue(plain.coverageMap().isEmpty());
    assertTrue(fixture.machine.coverage().isEmpty());
    long[] instructions = plain.tables().functions().getFirst().instructions();
    assertEquals(0, count(instructions, Op.MARK));
    long[] covered = fixture.compileCovered(text).tables().functions().getFirst().instructions();
    assertTrue(count(covered, Op.MARK) > 0);
    assertFalse(covered.length == instructions.length);
    assertArrayEquals(
        instructions, fixture.compile(text).tables().functions().getFirst().instructions());
  }

  private static long count(long[] instructions, int operation) {
    return Arrays.stream(instructions).filter(w -> Instruction.operation(w) == operation).count();
  }

  @Test
  void statementsAreReachedThatADebuggerSeesBegin() {
    int valid = 0;
    for (int seed = 0; valid < 60; seed++) {
      String text = new RandomScript(new Random(seed)).text();
      if (!new TranslationRuns(text, List.of()).valid()) {
        continue;
      }
      valid++;
      Set<Integer> begun = new HashSet<>();
      Coverage coverage = runTelling(text, begun);
      Set<Integer> reached =
          coverage.map().sites().stream()
              .filter(site -> site.kind() == Kind.STATEMENT && coverage.reached(site))
              .map(site -> site.range().start())
              .collect(Collectors.toSet());
      assertEquals(begun, reached, text);
    }
  }

  /** Adds the first offsets of the statements before which a debugger could stop in this run. */
  private static Coverage runTelling(String text, Set<Integer> begun) {
    MachineFixture fixture = new MachineFixture();
    fixture.machine.attach(
        new DebugHook() {
          @Override
          public void programStarted() {
            fixture.machine.probe().trapEverything();
          }

          @Override
          public boolean stopsAt(int thread) {
            begun.add(fixture.machine.probe().statementStart(thread).orElseThrow());
            return false;
          }
        });
    fixture.machine.start(fixture.compileCovered(text));
    fixture.advance(50);
    return fixture.machine.coverage().orElseThrow();
  }

  @Test
  void breakpointsStandWhereTheyStandWithoutCoverage() {
    for (int seed = 0; seed < 30; seed++) {
      String text = new RandomScript(new Random(seed)).text();
      MachineFixture fixture = new MachineFixture();
      if (!new TranslationRuns(text, List.of()).valid()) {
        continue;
      }
      List<ScriptFunction> plain = fixture.compile(text).tables().functions();
      List<ScriptFunction> covered = fixture.compileCovered(text).tables().functions();
      for (int i = 0; i < plain.size(); i++) {
        assertEquals(ranges(plain.get(i)), ranges(covered.get(i)), text);
        assertEquals(plain.get(i).callNs(), covered.get(i).callNs());
      }
    }
  }

  private static List<String> ranges(ScriptFunction function) {
    List<String> ranges = new ArrayList<>();
    for (int i = 0; i < function.statements().size(); i++) {
      ranges.add(
          function.statements().range(i)
              + " in line "
              + function.line(function.statements().pc(i)));
    }
    return ranges;
  }
}
