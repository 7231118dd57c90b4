package org.pendant.testing.mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class MutationRunTest {
  private static final String[] LARGER = {
    "def larger(a, b):", "  if a < b:", "    return b", "  end", "  return a", "end"
  };

  private static List<String> told(MutationReport report) {
    return report.files().stream()
        .flatMap(
            file ->
                file.mutants().stream()
                    .map(each -> each.status() + " " + each.mutation().after(file.source())))
        .toList();
  }

  @Test
  void mutantsThatATestNoticesAreKilledAndOthersSurvive() {
    MutationReport report =
        MutationSuite.of(LARGER)
            .tests("def test_larger():", "  assert_equal(larger(1, 2), 2)", "end")
            .run();

    assertEquals(
        List.of("KILLED if not (a < b):", "SURVIVED if a <= b:"),
        told(report).stream().sorted().toList());
  }

  @Test
  void theTestThatNoticesIsKnown() {
    MutationReport report =
        MutationSuite.of(LARGER)
            .tests(
                "def test_larger():",
                "  assert_equal(larger(1, 2), 2)",
                "end",
                "def test_of_something_else():",
                "end")
            .run();

    Mutant killed =
        report.files().getFirst().mutants().stream()
            .filter(each -> each.status() == MutantStatus.KILLED)
            .findFirst()
            .orElseThrow();
    assertEquals("test_larger", killed.killer().orElseThrow().name());
    assertEquals(1, killed.covering().size());
    assertTrue(killed.reason().contains("is 1"), killed.reason());
  }

  @Test
  void whatNoTestReachesIsNotCovered() {
    MutationReport report =
        MutationSuite.of(
                "def half(a):", "  return a / 2", "end", "def unused(a):", "  x = 3", "end")
            .tests("def test_half():", "  assert_near(half(4), 2)", "end")
            .run();

    assertEquals(
        List.of("KILLED return a * 2", "KILLED return a / 3", "NOT_COVERED x = 4"), told(report));
    assertEquals("66.7 %", report.score().text());
  }

  @Test
  void nodesOfTreesAreMutatedAsWell() {
    MutationReport report =
        new MutationSuite()
            .with(
                "lamp.pendant",
                "pendant program 1",
                "main",
                "  set setting=digital signal=\"digital_out[0]\" level=true",
                "  wait what=time time-s=0.1")
            .with(
                "lamp_test.script",
                "def test_lamp():",
                "  start(\"lamp.pendant\")",
                "  wait_for_end()",
                "  assert_true(get_standard_digital_out(0))",
                "end")
            .run();

    assertEquals(
        List.of(
            "KILLED ",
            "KILLED set setting=digital signal=\"digital_out[1]\" level=true",
            "KILLED set setting=digital signal=\"digital_out[0]\" level=false",
            "SURVIVED ",
            "SURVIVED wait what=time time-s=0.2"),
        told(report));
  }

  @Test
  void mutantsThatNeverEndAreTimedOut() {
    MutationReport report =
        MutationSuite.of(
                "def count():",
                "  n = 0",
                "  while n < 3:",
                "    n = n + 1",
                "    sync()",
                "  end",
                "  return n",
                "end")
            .tests("def test_count():", "  assert_equal(count(), 3)", "end")
            .run();

    assertTrue(told(report).contains("TIMED_OUT n = n - 1"), told(report).toString());
  }

  @Test
  void testsWithManyValuesKillAsOthersDo() {
    MutationReport report =
        MutationSuite.of(LARGER)
            .tests(
                "# @given 20",
                "def test_larger():",
                "  a = any_number(0, 1)",
                "  assert_true(larger(a, 0.5) >= a)",
                "end")
            .run();

    assertEquals(
        List.of("KILLED if not (a < b):", "SURVIVED if a <= b:"),
        told(report).stream().sorted().toList());
  }

  @Test
  void mutantsThatAreNoProgramsDoNotCount() {
    MutationReport report =
        MutationSuite.of(
                "def forever():", "  while True:", "    sync()", "    sleep(1)", "  end", "end")
            .with(
                "run_test.script",
                "def test_it_runs():",
                "  start(\"pick.script\")",
                "  sleep(1.5)",
                "  assert_true(program_running())",
                "end")
            .run();

    assertEquals(
        List.of("KILLED while False:"),
        told(report).stream().filter(e -> e.contains("while")).toList());
  }

  @Test
  void programsThatAreStartedAreMutatedAsThoseThatAreImported() {
    MutationReport report =
        MutationSuite.of(
                "def pick():", "  set_standard_digital_out(3, True)", "  sleep(0.5)", "end")
            .with(
                "run_test.script",
                "def test_it_grips():",
                "  start(\"pick.script\")",
                "  eventually(get_standard_digital_out(3), within=0.1)",
                "  wait_for_end()",
                "end")
            .run();

    assertEquals(
        List.of(
            "KILLED ",
            "KILLED set_standard_digital_out(2, True)",
            "KILLED set_standard_digital_out(3, False)",
            "SURVIVED ",
            "SURVIVED sleep(1.0)"),
        told(report));
  }

  @Test
  void itMakesNoDifferenceHowManyAreTriedAtOnce() {
    MutationSuite suite =
        MutationSuite.of(LARGER)
            .tests(
                "def test_larger():",
                "  assert_equal(larger(1, 2), 2)",
                "end",
                "def test_smaller():",
                "  assert_equal(larger(2, 1), 2)",
                "end");

    MutationReport one = suite.run();
    MutationReport four = suite.with(new MutationSettings(List.of(), 0, 1, 4)).run();

    assertEquals(one.files().getFirst().mutants(), four.files().getFirst().mutants());
  }

  @Test
  void theSeedChoosesWhichAreTriedWhereThereAreMany() {
    String[] many = new String[42];
    many[0] = "def many():";
    for (int i = 1; i < 41; i++) {
      many[i] = "  x" + i + " = " + i;
    }
    many[41] = "end";
    MutationSuite suite = MutationSuite.of(many).tests("def test_many():", "  many()", "end");

    List<String> first = told(suite.with(new MutationSettings(List.of(), 5, 7, 1)).run());
    List<String> again = told(suite.with(new MutationSettings(List.of(), 5, 7, 1)).run());
    MutationReport other = suite.with(new MutationSettings(List.of(), 5, 8, 1)).run();

    assertEquals(5, first.size());
    assertEquals(first, again);
    assertTrue(!first.equals(told(other)), first.toString());
    assertEquals(40, other.places());
  }

  @Test
  void itTellsHowFarItHasCome() {
    MutationSuite suite =
        MutationSuite.of(LARGER)
            .tests("def test_larger():", "  assert_equal(larger(1, 2), 2)", "end")
            .with(new MutationSettings(List.of(), 0, 1, 2));

    suite.run();

    assertEquals(List.of("1 of 2", "2 of 2"), suite.progress());
  }

  @Test
  void onlyProgramsOfTheNamesThatAreAskedForAreMutated() {
    MutationReport report =
        MutationSuite.of(LARGER)
            .tests("def test_larger():", "  assert_equal(larger(1, 2), 2)", "end")
            .with(new MutationSettings(List.of("other"), 0, 1, 1))
            .run();

    assertEquals(0, report.files().size());
    assertEquals("-", report.score().text());
  }

  /** Its tests that call functions alone, so that it takes a moment and not minutes. */
  private static byte[] example(String name) throws IOException {
    String tests = "tests/functions_test.script";
    Path examples = Path.of("../../examples");
    if (!name.equals(tests)) {
      return Files.readAllBytes(examples.resolve(name));
    }
    String all = Files.readString(examples.resolve("tests/palletizing_test.script"));
    return all.substring(0, all.indexOf("# The gripper lets go")).getBytes(StandardCharsets.UTF_8);
  }

  @Test
  void testsOfThePalletizingExampleKillWhatTheyClaimOfItsPlaces() {
    MutationReport report =
        new MutationSuite()
            .with(new MutationSettings(List.of(), 0, 1, 2))
            .run(MutationRunTest::example, List.of("tests/functions_test.script"));

    // what the whole program makes of it, a test that is left out here claims
    List<String> survivors =
        told(report).stream()
            .filter(each -> each.startsWith("SURVIVED"))
            .filter(each -> !each.contains("home = ") && !each.contains("LAYERS = "))
            .toList();
    assertEquals(List.of(), survivors);
    assertTrue(report.score().killed() > 40, report.score().toString());
  }
}
