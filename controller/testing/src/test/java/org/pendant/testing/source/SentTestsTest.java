package org.pendant.testing.source;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.message.LogEntry;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;
import org.pendant.testing.builtin.TestBuiltins;

/** What tests are as programs, which a controller without functions of tests runs here. */
class SentTestsTest {
  private static final String FILE = "cell/sum_test.script";

  private final Map<String, String> files = new HashMap<>();

  private SentTest sent(String... lines) {
    files.put(FILE, String.join("\n", lines) + "\n");
    TestFileReader reader =
        new TestFileReader(
            name -> {
              String text = files.get(name);
              if (text == null) {
                throw new IOException("no such file");
              }
              return text.getBytes(StandardCharsets.UTF_8);
            },
            TestBuiltins.create(),
            false);
    try {
      TestFile file = reader.read(FILE);
      TestCase test = file.tests().getFirst();
      return file.sent().of(test, file.calls().get(test.id().function()), "MARK");
    } catch (TestFileReader.Broken e) {
      throw new AssertionError(e);
    }
  }

  /** What a program says until it ends. */
  private static List<String> said(SentTest test) {
    Controller controller = new Controller(ControllerOptions.headless().withArm(ArmChoice.IDEAL));
    LoadResult loaded = controller.load(Source.of("sent", test.text()));
    assertEquals(List.of(), loaded.diagnostics().stream().filter(Diagnostic::isError).toList());
    var reply = controller.submit(new ProgramCommand.StartProgram(loaded.program().orElseThrow()));
    assertTrue(
        controller.runUntil(
            () -> reply.isDone() && controller.state().program().state() == ProgramState.STOPPED,
            5_000));
    return controller.logSince(0).stream()
        .filter(each -> each.origin() == LogEntry.Origin.SCRIPT)
        .map(LogEntry::text)
        .toList();
  }

  private List<String> ran(String... lines) {
    return said(sent(lines));
  }

  @Test
  void aTestRunsBetweenWhatStandsAroundItAndTellsItsEnd() {
    assertEquals(
        List.of("before 1", "test 3", "after", "MARK done 0 "),
        ran(
            "N = 3",
            "count = 0",
            "def before_each():",
            "  count = count + 1",
            "  textmsg(\"before \", count)",
            "end",
            "def after_each():",
            "  textmsg(\"after\")",
            "end",
            "def test_it():",
            "  textmsg(\"test \", N)",
            "  assert_equal(count, 1)",
            "end"));
  }

  @Test
  void assertionsThatHoldLetTheTestGoOn() {
    assertEquals(
        List.of("MARK done 0 "),
        ran(
            "def test_it():",
            "  assert_true(1 < 2)",
            "  assert_false(1 > 2, message=\"own\")",
            "  assert_equal([1, 2], [1, 2])",
            "  assert_equal(\"a\", \"a\")",
            "  assert_not_equal(p[0, 0, 0, 0, 0, 0], p[0, 0, 1, 0, 0, 0])",
            "  assert_near(0.1 + 0.2, 0.3)",
            "  assert_near([1.0, 2], [1, 2.05], tolerance=0.1)",
            "  assert_joints_near([0, 0, 0, 0, 0, 0], [0, 0, 0.001, 0, 0, 0])",
            "  assert_pose_near(p[0, 0, 0, 0, 0, 0], p[0, 0, 0.001, 0, 0, 0], mm=2)",
            "end"));
  }

  @Test
  void eachAssertionThatDoesNotHoldTellsItsLineAndEndsTheTest() {
    Map<String, String> expected =
        Map.of(
            "assert_true(1 > 2)",
            "assert_true: condition is False, must be True",
            "assert_false(1 < 2, \"own\")",
            "own: condition is True, must be False",
            "assert_equal([1, 2], [1, 3])",
            "assert_equal: is [1, 2], must be [1, 3]",
            "assert_not_equal(1, 1)",
            "assert_not_equal: is 1, must be anything else",
            "assert_near(1, 2, 0.5)",
            "assert_near: is 1, must be 2 +- 0.5",
            "assert_near([1, 2], [1, 2, 3])",
            "assert_near: is [1, 2], must be [1, 2, 3] +- 0.000001",
            "assert_joints_near([0, 0, 1, 0, 0, 0], [0, 0, 0, 0, 0, 0])",
            "assert_joints_near: joint 2 is 1, must be 0",
            "assert_pose_near(p[0, 0, 0, 0, 0, 0], p[0, 0, 0, 0, 0, 1])",
            "assert_pose_near: is p[0, 0, 0, 0, 0, 0], must be p[0, 0, 0, 0, 0, 1]",
            "fail()",
            "fail: the test says so");
    expected.forEach(
        (line, told) ->
            assertEquals(
                List.of("MARK failed 2 " + told),
                ran("def test_it():", "  " + line, "  textmsg(\"not reached\")", "end")));
  }

  @Test
  void anAssertionInAThreadEndsTheTestAsWell() {
    assertEquals(
        List.of("MARK failed 2 fail: the test says so"),
        ran("thread t():", "  fail()", "end", "def test_it():", "  run t()", "  sleep(1)", "end"));
  }

  @Test
  void aTestThatHaltsHasComeToItsEnd() {
    assertEquals(
        List.of("MARK done 0 "),
        ran("def test_it():", "  if True:", "    halt", "  end", "  fail()", "end"));
  }

  @Test
  void skippingAndExpectingAreToldToo() {
    assertEquals(
        List.of("MARK expects 2 too far", "MARK skipped 3 no gripper"),
        ran("def test_it():", "  expect_failure(\"too far\")", "  skip(\"no gripper\")", "end"));
  }

  @Test
  void importedFunctionsSeeTheValuesOfTheirFileAndKeepTheirLines() {
    files.put(
        "cell/lib.script",
        """
        def lib():
          local HEIGHT = 5
          def above(a):
            return a + HEIGHT
          end
          movej([0, 0, 0, 0, 0, 0])
        end
        """);
    SentTest sent =
        sent(
            "import_script(\"lib.script\")",
            "def other():",
            "  mock(\"sleep\")",
            "end",
            "# @case 6",
            "def test_it(n):",
            "  assert_equal(above(n), 11)",
            "end");

    assertEquals(List.of("MARK done 0 "), said(sent));
    assertFalse(sent.text().contains("mock"), sent.text());
    assertFalse(sent.text().contains("movej"), sent.text());
    int line = 1 + sent.text().lines().toList().indexOf("      return a + HEIGHT");
    // the file of tests has 8 lines
    assertEquals(8 + 4, sent.lineOf(line));
    assertEquals(14, sent.columnOf(line, 16));
    assertEquals(6, sent.lineOf(1));
  }
}
