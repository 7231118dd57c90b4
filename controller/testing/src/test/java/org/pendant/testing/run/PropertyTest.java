package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

class PropertyTest {
  private static String message(TestResult result) {
    return result.failure().orElseThrow().message();
  }

  @Test
  void aPropertyThatHoldsPasses() {
    TestResult result =
        Suite.of(
                "# @given 50",
                "def test_inverse():",
                "  pose = any_pose_in_reach()",
                "  assert_true(get_inverse_kin_has_solution(pose))",
                "  n = any_int(-3, 3)",
                "  assert_true(n >= -3 and n <= 3)",
                "  x = any_number(-1, 2)",
                "  assert_true(x >= -1 and x <= 2)",
                "  assert_contains([1, 2, 3], any_of([1, 2, 3]))",
                "end")
            .only();

    assertEquals(Optional.empty(), result.failure());
    assertEquals(TestStatus.PASSED, result.status());
  }

  @Test
  void theValuesOfARedRunAreMadeAsSimpleAsTheyCanBe() {
    TestResult result =
        Suite.of(
                "# @given 200",
                "def test_small():",
                "  a = any_int(0, 1000)",
                "  b = any_bool()",
                "  assert_true(a < 17)",
                "end")
            .only();

    assertEquals(TestStatus.FAILED, result.status());
    List<String> lines = message(result).lines().toList();
    assertEquals("assert_true: condition is False, must be True", lines.get(0));
    assertEquals("with 17, False", lines.get(1));
    assertTrue(lines.get(2).startsWith("found in run 1 of 200; # @example 0.0"), lines.get(2));
  }

  @Test
  void aReportSaysThatARunHasMadeUpNoValues() {
    TestResult result =
        Suite.of("# @given 5", "def test_it():", "  assert_true(False)", "end").only();

    assertEquals("with no values", message(result).lines().toList().get(1));
  }

  @Test
  void theLineOfAReportRepeatsTheRun() {
    String[] test = {
      "def test_small():", "  a = any_number(0, 100)", "  assert_true(a < 40)", "end"
    };
    TestResult found = Suite.of("# @given 100\n" + String.join("\n", test)).only();
    String line = message(found).lines().toList().get(2);
    String mark = line.substring(line.indexOf("# @example"), line.indexOf(" above"));

    TestResult repeated = Suite.of(mark + "\n" + String.join("\n", test)).only();

    assertEquals(message(found).lines().toList().get(1), message(repeated).lines().toList().get(1));
    assertTrue(message(repeated).contains("found in run 1 of 1"), message(repeated));
  }

  @Test
  void runsWhoseAssumptionDoesNotHoldDoNotCount() {
    TestResult result =
        Suite.of(
                "# @given 100",
                "def test_positive():",
                "  a = any_number(-1, 1)",
                "  assume(a > 0)",
                "  assert_true(a > 0)",
                "end",
                "# @given 5",
                "def test_none():",
                "  assume(False)",
                "end")
            .run()
            .results()
            .getFirst();

    assertEquals(TestStatus.PASSED, result.status());
  }
}
