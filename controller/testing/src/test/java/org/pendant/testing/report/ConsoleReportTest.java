package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;
import org.pendant.testing.report.ConsoleStyle.Detail;
import org.pendant.testing.report.ConsoleStyle.Feature;
import org.pendant.text.Language;
import org.pendant.text.Texts;

class ConsoleReportTest {
  private static final String SUMMARY =
      """
      ✗ cell/grip_test.script test_grip[0.05, True]: failed after 0.100 s of robot time
      cell/grip_test.script:2:3: error: width is 0.05 m, expected 0.04 m
        | within 0.001 m
        assert_near(width, 0.04, 0.001)
        ^
        in close, cell/grip_test.script:2:3
        in test_grip, cell/grip_test.script:6:3
        output:
          | closing
          | width 0.05

      ✗ cell/grip_test.script test_force: ended by an error after 0.500 s of robot time
      cell/grip_test.script:10:3: error: force_mode: 4 arguments are missing
        force_mode(p[0,0,0,0,0,0])
        ^

      ✗ cell/grip_test.script test_forever: timed out after 0.500 s of robot time
      cell/grip_test.script:9:1: error: ran longer than 60 s of robot time

      ✗ cell/old_test.script: no test of it could run
      cell/old_test.script:3:5: error: `movee` is not known
        movee(q)
        ^~~~~

      3 passed, 1 failed, 1 error, 1 timed out, 1 skipped, 1 broken file, 2 not run in 3.6 s of\
       robot time (seed 4711)
      """;

  private static final String FILES =
      """
      ✓ cell/pick_test.script: 2 passed, 1 skipped in 2.5 s
      ✗ cell/grip_test.script: 1 passed, 1 failed, 1 error, 1 timed out in 1.1 s
        ✗ test_grip[0.05, True]: width is 0.05 m, expected 0.04 m (cell/grip_test.script:2:3)
        ✗ test_force: force_mode: 4 arguments are missing (cell/grip_test.script:10:3)
        ✗ test_forever: ran longer than 60 s of robot time

      """;

  @Test
  void tellsFilesThenRedTestsInDetailThenHowManyThereWere() {
    assertEquals(FILES + SUMMARY, text(SampleSuite.suite(), Detail.NORMAL));
  }

  @Test
  void speaksTheLanguageOfWhoReadsIt() {
    assertEquals(
        """
        ✗ cell/grip_test.script test_force: durch einen Fehler beendet nach 0.500 s Roboterzeit
        cell/grip_test.script:10:3: Fehler: force_mode: es fehlen 4 Argumente
          force_mode(p[0,0,0,0,0,0])
          ^
        """,
        block(1, in(Language.GERMAN)));
    assertEquals(
        "3 bestanden, 1 fehlgeschlagen, 1 Fehler, 1 mit Zeitüberschreitung, 1 übersprungen,"
            + " 1 fehlerhafte Datei, 2 nicht ausgeführt in 3.6 s Roboterzeit (Seed 4711)\n",
        block(4, in(Language.GERMAN)));
    assertEquals(
        "3 个通过，1 个失败，1 个错误，1 个超时，1 个跳过，1 个文件有错误，2 个未运行，机器人时间 3.6 s" + "（随机种子 4711）\n",
        block(4, in(Language.CHINESE)));
  }

  private static String in(Language language) {
    StringBuilder text = new StringBuilder();
    ReportLanguage report =
        new ReportLanguage(
            Texts.of(ReportLanguage.class, language),
            english -> english.replace("4 arguments are missing", "es fehlen 4 Argumente"));
    ConsoleReport console =
        new ConsoleReport(ConsoleStyle.of(Detail.QUIET), SampleSuite::source, text::append, report);
    console.end(SampleSuite.suite());
    return text.toString();
  }

  private static String block(int number, String text) {
    String block = text.split("\n\n")[number];
    return block.endsWith("\n") ? block : block + "\n";
  }

  @Test
  void tellsOnlyRedTestsAndTheSumWhenQuiet() {
    assertEquals(SUMMARY, text(SampleSuite.suite(), Detail.QUIET));
  }

  @Test
  void isOneLineWhenQuietAndNothingIsRed() {
    SuiteResult suite = SampleSuite.of(SampleSuite.passed("a.script", "test_a", 12.34));
    assertEquals("1 passed in 12.3 s of robot time (seed 1)\n", text(suite, Detail.QUIET));
  }

  @Test
  void tellsEachTestWhenVerbose() {
    String text = text(SampleSuite.suite(), Detail.VERBOSE);
    assertTrue(
        text.startsWith(
            """
            ✓ cell/pick_test.script: 2 passed, 1 skipped in 2.5 s
              ✓ test_pick in 1.3 s
              ✓ test_place in 1.2 s
              ○ test_two_arms: there is one arm; see #7
            ✗ cell/grip_test.script: 1 passed, 1 failed, 1 error, 1 timed out in 1.1 s
              ✓ test_open in 0.046 s
            """),
        text);
  }

  @Test
  void hasMarksOfLettersForTerminalsWithoutUtf8() {
    String text = text(SampleSuite.suite(), Detail.VERBOSE, Feature.ASCII);
    assertTrue(text.chars().allMatch(each -> each < 0x80), text);
    assertTrue(text.contains("  ok   test_pick"), text);
    assertTrue(text.contains("  skip test_two_arms"), text);
    assertTrue(text.contains("  FAIL test_force"), text);
  }

  @Test
  void hasColoursOnlyWhenAsked() {
    assertFalse(text(SampleSuite.suite(), Detail.VERBOSE).contains("\u001b"));
    String text = text(SampleSuite.suite(), Detail.NORMAL, Feature.COLOURS);
    assertTrue(text.startsWith("\u001b[32m✓\u001b[0m cell/pick_test.script"), text);
    assertEquals(FILES + SUMMARY, text.replaceAll("\u001b\\[\\d*m", ""));
  }

  @Test
  void tellsTheWallTimeLastAndOnlyWhenAsked() {
    String text = text(SampleSuite.suite(), Detail.QUIET, Feature.WALL_TIME);
    assertEquals(SUMMARY + "1.5 s by the wall clock\n", text);
  }

  @Test
  void saysSoWhenThereAreNoTests() {
    assertEquals("no tests (seed 1)\n", text(SampleSuite.of(), Detail.NORMAL));
  }

  @Test
  void isTheSameInWhateverOrderTestsEnd() {
    SuiteResult suite = SampleSuite.many(1_000);
    String inOrder = text(suite, Detail.VERBOSE);
    List<TestResult> shuffled = new ArrayList<>(suite.results());
    Collections.shuffle(shuffled, new Random(1));
    assertEquals(inOrder, text(suite, shuffled, Detail.VERBOSE));
  }

  @Test
  void writesAFileAsSoonAsItAndThoseAboveItHaveEnded() {
    SuiteResult suite = SampleSuite.suite();
    StringBuilder text = new StringBuilder();
    ConsoleReport report = report(text, Detail.NORMAL);
    report.begin(suite.results().stream().map(TestResult::id).toList());
    suite.results().stream().skip(2).forEach(report::finished);
    assertEquals("", text.toString());
    report.finished(suite.results().get(0));
    report.finished(suite.results().get(1));
    assertEquals(FILES.stripTrailing() + "\n", text.toString());
  }

  @Test
  void tellsTestsOfFilesThatDidNotComeToTheirEnd() {
    SuiteResult suite = SampleSuite.of(SampleSuite.passed("a.script", "test_a", 1));
    StringBuilder text = new StringBuilder();
    ConsoleReport report = report(text, Detail.NORMAL);
    report.begin(
        List.of(
            suite.results().getFirst().id(),
            SampleSuite.passed("a.script", "test_b", 1).id(),
            SampleSuite.passed("b.script", "test_c", 1).id()));
    suite.results().forEach(report::finished);
    assertEquals("", text.toString());
    report.end(suite);
    assertEquals(
        """
        ✓ a.script: 1 passed in 1.0 s

        1 passed in 1.0 s of robot time (seed 1)
        """,
        text.toString());
  }

  @Test
  void tellsRedTestsOfATerminalAtOnceAndWritesItsProgressOver() {
    SuiteResult suite = SampleSuite.suite();
    StringBuilder text = new StringBuilder();
    ConsoleReport report = report(text, Detail.NORMAL, Feature.TERMINAL);
    report.begin(suite.results().stream().map(TestResult::id).toList());
    report.finished(suite.results().getLast());
    assertEquals(
        "0 of 7 tests\r            \r"
            + "✗ cell/grip_test.script test_forever: ran longer than 60 s of robot time\n"
            + "1 of 7 tests, 1 red",
        text.toString());
    suite.results().stream().limit(6).forEach(report::finished);
    report.end(suite);
    assertTrue(text.toString().endsWith("\n" + SUMMARY), text.toString());
    assertTrue(
        text.toString().contains("\r✓ cell/pick_test.script: 2 passed, 1 skipped in 2.5 s\n"));
  }

  @Test
  void writesItsProgressRarelyBesideManyTests() {
    SuiteResult suite = SampleSuite.many(20_000);
    int[] pieces = {0};
    ConsoleReport report =
        new ConsoleReport(
            ConsoleStyle.of(Detail.QUIET, Feature.TERMINAL),
            SampleSuite::source,
            piece -> pieces[0]++);
    report.begin(suite.results().stream().map(TestResult::id).toList());
    suite.results().stream().filter(each -> !each.status().red()).forEach(report::finished);
    assertTrue(pieces[0] < 2_000, pieces[0] + " pieces");
  }

  @Test
  void asksForTheTextOfAFileOnce() {
    List<String> asked = new ArrayList<>();
    ConsoleReport report =
        new ConsoleReport(
            ConsoleStyle.of(Detail.NORMAL),
            file -> {
              asked.add(file);
              return SampleSuite.source(file);
            },
            piece -> {});
    report.end(SampleSuite.many(100));
    assertEquals(List.of(SampleSuite.GRIP), asked);
  }

  @Test
  void showsControlCharactersAndKeepsLinesOfTestsFromPassingForOthers() {
    String text =
        text(
            SampleSuite.of(
                SampleSuite.failed(
                    "a\u001b[2Jb\r\n::error::forged\n9 passed",
                    List.of("\u0007\n::stop", "\u202e"))),
            Detail.VERBOSE);
    assertEquals(
        """
        ✗ cell/grip_test.script: 0 passed, 1 failed in 0.500 s
          ✗ test_x: a\\x1b[2Jb\\x0d

        ✗ cell/grip_test.script test_x: failed after 0.500 s of robot time
        cell/grip_test.script:9:1: error: a\\x1b[2Jb\\x0d
          | ::error::forged
          | 9 passed
          output:
            | \\x07\\x0a::stop
            | \\u202e

        0 passed, 1 failed in 0.500 s of robot time (seed 1)
        """,
        text);
  }

  @Test
  void decodesWhatScriptsHaveAsBytes() {
    String text =
        text(SampleSuite.of(SampleSuite.failed("`\u00C3\u00A9`", List.of())), Detail.QUIET);
    assertTrue(text.contains("error: `é`\n"), text);
  }

  @Test
  void hasTheLastLinesOfMuchOutput() {
    List<String> output = new ArrayList<>();
    for (int i = 1; i <= 100_000; i++) {
      output.add("line " + i + " " + "x".repeat(100));
    }
    String text = text(SampleSuite.of(SampleSuite.failed("m", output)), Detail.QUIET);
    assertTrue(text.length() < 3_000, text);
    assertTrue(text.contains("  output, last 10 of 100000 lines:\n    | line 99991 "), text);
  }

  @Test
  void boundsALineOfTenMegabytes() {
    String much = "\u001b".repeat(10_000_000);
    String text = text(SampleSuite.of(SampleSuite.failed(much, List.of(much))), Detail.NORMAL);
    assertTrue(text.length() < 100_000, text.length() + " characters");
    assertTrue(text.contains("... (10000000 characters)"), text);
  }

  @Test
  void showsTheEndsOfADeepCallStack() {
    List<TestPlace> stack =
        Collections.nCopies(10_000, new TestPlace(SampleSuite.GRIP, 6, 0, "deeper"));
    TestResult red =
        SampleSuite.red(
            "test_deep",
            TestStatus.ERROR,
            new TestFailure("recursion", "too deep", Optional.empty(), stack));
    String text = text(SampleSuite.of(red), Detail.QUIET);
    assertTrue(text.lines().count() < 30, text);
    assertTrue(text.contains("  in deeper, cell/grip_test.script:6\n  ... 9980 more\n"), text);
  }

  @Test
  void doesWithoutALineThatTheTextDoesNotHave() {
    TestPlace beyond = new TestPlace(SampleSuite.GRIP, 900, 3, "");
    TestResult red =
        SampleSuite.red(
            "test_x",
            TestStatus.FAILED,
            new TestFailure("x", "changed since", Optional.of(beyond), List.of()));
    assertEquals(
        """
        ✗ cell/grip_test.script test_x: failed after 0.500 s of robot time
        cell/grip_test.script:900:3: error: changed since

        0 passed, 1 failed in 0.500 s of robot time (seed 1)
        """,
        text(SampleSuite.of(red), Detail.QUIET));
  }

  private static String text(SuiteResult suite, Detail detail, Feature... features) {
    return text(suite, suite.results(), detail, features);
  }

  private static String text(
      SuiteResult suite, List<TestResult> ended, Detail detail, Feature... features) {
    StringBuilder text = new StringBuilder();
    ConsoleReport report = report(text, detail, features);
    report.begin(suite.results().stream().map(TestResult::id).toList());
    ended.forEach(report::finished);
    report.end(suite);
    return text.toString();
  }

  private static ConsoleReport report(StringBuilder text, Detail detail, Feature... features) {
    return new ConsoleReport(ConsoleStyle.of(detail, features), SampleSuite::source, text::append);
  }
}
