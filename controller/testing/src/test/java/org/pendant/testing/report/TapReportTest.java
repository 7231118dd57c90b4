package org.pendant.testing.report;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.testing.SuiteResult;

class TapReportTest {

  @Test
  void hasAPlanALineForEachTestAndYamlBelowRedOnes() throws Exception {
    assertEquals(
        """
        TAP version 14
        1..8
        # seed 4711
        ok 1 - cell/pick_test.script test_pick
        ok 2 - cell/pick_test.script test_place
        ok 3 - cell/pick_test.script test_two_arms # SKIP there is one arm; see \\#7
        ok 4 - cell/grip_test.script test_open
        not ok 5 - cell/grip_test.script test_grip[0.05, True]
          ---
          message: "width is 0.05 m, expected 0.04 m\\nwithin 0.001 m"
          severity: "fail"
          code: "assertion-failed"
          duration_ms: 100
          file: "cell/grip_test.script"
          line: 2
          column: 3
          stack:
            - "in close, cell/grip_test.script:2:3"
            - "in test_grip, cell/grip_test.script:6:3"
          output: "closing\\nwidth 0.05"
          ...
        not ok 6 - cell/grip_test.script test_force
          ---
          message: "force_mode: 4 arguments are missing"
          severity: "error"
          code: "missing-argument"
          duration_ms: 500
          file: "cell/grip_test.script"
          line: 10
          column: 3
          ...
        not ok 7 - cell/grip_test.script test_forever
          ---
          message: "ran longer than 60 s of robot time"
          severity: "error"
          code: "timed-out"
          duration_ms: 500
          file: "cell/grip_test.script"
          line: 9
          column: 1
          ...
        not ok 8 - cell/old_test.script (the file itself)
          ---
          message: "cell/old_test.script:3:5: error: `movee` is not known\\n  movee(q)\\n  ^~~~~"
          severity: "error"
          code: "broken-file"
          ...
        # not run: 2 tests
        """,
        text(SampleSuite.suite()));
  }

  @Test
  void noNameAndNoReasonIsTakenForADirective() throws Exception {
    String text =
        text(
            SampleSuite.of(
                SampleSuite.passed("a.script", "test_a # TODO \\ later", 1),
                SampleSuite.skipped("a.script", "test_b", "b\nnot ok 1 # x"),
                SampleSuite.skipped("a.script", "test_c", "")));
    assertEquals(
        """
        TAP version 14
        1..3
        # seed 1
        ok 1 - a.script test_a \\# TODO \\\\ later
        ok 2 - a.script test_b # SKIP b\\\\x0anot ok 1 \\# x
        ok 3 - a.script test_c # SKIP
        """,
        text);
  }

  @Test
  void noTextLeavesItsQuotes() throws Exception {
    String text =
        text(
            SampleSuite.of(
                SampleSuite.failed("a \"b\" \\ \u001b\n...\nok 9\t\uFEFF", List.of("...", "\r"))));
    assertTrue(
        text.contains("  message: \"a \\\"b\\\" \\\\ \\\\x1b\\n...\\nok 9\\t\\ufeff\"\n"), text);
    assertTrue(text.contains("  output: \"...\\n\\\\x0d\"\n"), text);
  }

  @Test
  void boundsOutput() throws Exception {
    List<String> output = Collections.nCopies(100_000, "x".repeat(100));
    assertTrue(text(SampleSuite.of(SampleSuite.failed("m", output))).length() < 20_000);
  }

  private static String text(SuiteResult suite) throws IOException {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TapReport.write(suite, out);
    return out.toString(StandardCharsets.UTF_8);
  }
}
