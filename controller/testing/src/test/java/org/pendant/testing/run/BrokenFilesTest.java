package org.pendant.testing.run;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class BrokenFilesTest {
  @Test
  void aFileThatDoesNotParseTellsWhere() {
    List<String> problems =
        Suite.of("def test_a():", "  x = unknown_thing(3)", "  y = 1 + + ", "end").problems();

    assertEquals(1, problems.size(), problems.toString());
    assertEquals("cell/pick_test.script:4:", problems.getFirst().substring(0, 24));
  }

  @Test
  void aMistakeInAnImportedScriptIsToldWithItsPlaceThere() {
    List<String> problems =
        Suite.of("import_script(\"lib.script\")", "def test_a():", "  x = f()", "end")
            .with("cell/lib.script", "def f():", "  return missing_name(1)", "end")
            .problems();

    assertEquals("cell/lib.script:2:10: error: ", problems.getFirst().substring(0, 29));
  }

  @Test
  void aFileWithoutTestsIsBroken() {
    assertEquals(
        List.of(
            "cell/pick_test.script: error: it holds no test; a test is a function test_...() in"
                + " it"),
        Suite.of("def helper():", "  sync()", "end").problems());
  }

  @Test
  void aTestWithParametersNeedsCases() {
    assertEquals(
        List.of(
            "cell/pick_test.script:1:5: error: test_a has parameters and no case: a comment line #"
                + " @case ARGUMENTS above it gives one"),
        Suite.of("def test_a(n):", "  sync()", "end").problems());
  }

  @Test
  void aMarkThatThereIsNotIsAMistake() {
    assertEquals(
        List.of(
            "cell/pick_test.script:1:3: error: @slow is no mark of a test; there are @tag, @skip,"
                + " @timeout, @start_at, @scene, @case, @given, @example and @golden"),
        Suite.of("# @slow", "def test_a():", "  sync()", "end").problems());
  }

  @Test
  void aSceneThatCannotBeIsAMistakeWhereItIsNamed() {
    assertEquals(
        List.of(
            "cell/pick_test.script:1:10: error: @scene: cell/x.json:1:37: part is 30 m, must be 0"
                + " to 0.11 m"),
        Suite.of("# @scene x.json", "def test_a():", "  sync()", "end")
            .with("cell/x.json", "{\"devices\": [{\"type\": \"rg\", \"part\": 30}]}")
            .problems());
  }

  @Test
  void aStartThatNoArmCanBeAtIsAMistake() {
    for (String each : List.of("10, 20", "0, -90, -90, -90, 90, far", "0, 0, 0, 0, 0, 3601")) {
      assertEquals(
          List.of(
              "cell/pick_test.script:1:13: error: @start_at is '"
                  + each
                  + "', must be six joints in degrees, -360 to 360 each"),
          Suite.of("# @start_at " + each, "def test_a():", "  sync()", "end").problems());
    }
  }

  @Test
  void aCaseWithTooManyArgumentsIsToldWhereItStands() {
    List<String> problems =
        Suite.of("# @case 1, 2", "def test_a(n):", "  sync()", "end").problems();

    assertEquals("cell/pick_test.script:1:9: error: ", problems.getFirst().substring(0, 34));
  }

  @Test
  void aTestThatStartsAProgramMayNotMoveTheArmItself() {
    assertEquals(
        List.of(
            "cell/pick_test.script:2:3: error: movej: test_a starts a program, and a test that"
                + " does only watches: it moves nothing itself"),
        Suite.of(
                "def go():",
                "  movej([0, -1.5, 0, -1.5, 0, 0])",
                "end",
                "def test_a():",
                "  start(\"pick.script\")",
                "  go()",
                "end")
            .problems());
  }

  @Test
  void anImportOfAFileThatIsNotThereIsToldWhereItStands() {
    assertEquals(
        List.of("cell/pick_test.script:1:1: error: import_script: cell/gone.script: no such file"),
        Suite.of("import_script(\"gone.script\")", "def test_a():", "  sync()", "end").problems());
  }

  @Test
  void anExpectationWithAWrongArgumentIsToldAsAnyCallIs() {
    List<String> problems =
        Suite.of("def test_a():", "  eventually(True, after=3)", "end").problems();

    assertEquals("cell/pick_test.script:2:", problems.getFirst().substring(0, 24));
  }

  @Test
  void aMockNeedsTheNameOfAFunctionInQuotes() {
    assertEquals(
        List.of("cell/pick_test.script:3:3: error: mock needs the name of a function in quotes"),
        Suite.of("def test_a():", "  name = \"grip\"", "  mock(name, 3)", "end").problems());
  }

  @Test
  void aGoldenTestMayNotHaveOtherValuesEachTime() {
    assertEquals(
        List.of(
            "cell/pick_test.script:1:12: error: @golden is for a test that does the same each time;"
                + " one with @given or @example does not"),
        Suite.of("#  @golden deg=1", "# @given 3", "def test_a():", "  sync()", "end").problems());
  }

  @Test
  void aToleranceOfAGoldenTestThatIsNoneIsAMistake() {
    assertEquals(
        List.of(
            "cell/pick_test.script:1:11: error: @golden is 'deg=-1', may have deg=DEGREES,"
                + " mm=MILLIMETRES and s=SECONDS, each 0 or more, s at most 5"),
        Suite.of("# @golden deg=-1", "def test_a():", "  sync()", "end").problems());
    assertEquals(
        1, Suite.of("# @golden s=6", "def test_a():", "  sync()", "end").problems().size());
  }
}
