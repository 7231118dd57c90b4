package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.testing.SuiteResult;

class WarningsTest {
  @Test
  void whatTheCheckerWarnsOfInAFileOfTestsIsToldOnceWithItsPlace() {
    SuiteResult result =
        Suite.of(
                "def test_a():",
                "  assert_true(True)",
                "end",
                "def test_b():",
                "  if False:",
                "    textmsg(nothing)",
                "  end",
                "end")
            .run();

    assertEquals(2, result.results().size());
    assertEquals(
        List.of("cell/pick_test.script:6:13: warning: variable nothing is never assigned"),
        result.warningsOf("cell/pick_test.script"));
  }

  @Test
  void whatTestsAreMadeOfIsNoReasonForAWarning() {
    SuiteResult result =
        Suite.of(
                "import_script(\"pick.script\")",
                "count = 0",
                "def before_each():",
                "  count = 0",
                "end",
                "def held(force, width=1):",
                "  count = count + 1",
                "  return force > 3",
                "end",
                "# @case 1",
                "def test_a(n):",
                "  mock_by(\"grip\", \"held\")",
                "  mock(\"movej\")",
                "  grip(n)",
                "  eventually(count == 1, within=1)",
                "  never(count > 1, during=0.1)",
                "end")
            .with(
                "cell/pick.script",
                "def pick():",
                "  def grip(force):",
                "    return nothing",
                "  end",
                "end")
            .run();

    assertEquals(List.of(), result.warnings());
    assertEquals(1, result.results().size());
  }
}
