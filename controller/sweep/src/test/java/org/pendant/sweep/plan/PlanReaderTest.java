package org.pendant.sweep.plan;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class PlanReaderTest {
  private static List<String> mistakes(String text) {
    return assertThrows(PlanException.class, () -> PlanReader.read("p.toml", text)).reports();
  }

  @Test
  void planHasWhatItsFileSays() throws PlanException {
    SweepPlan plan =
        PlanReader.read(
            "p.toml",
            """
            program = "pick.script"
            robot = "ur10e"
            scene = "cell.json"
            arm = "ideal"
            seed = 7
            time_limit = 20
            variables = ["parts"]
            fixed = ["place"]
            inputs = ["digital_in[0]=true"]
            [sampling]
            method = "grid"
            [[parameter]]
            name = "v"
            set = "variable FAST"
            from = 0.5
            to = 1.5
            steps = 3
            [[parameter]]
            set = "variable place[1]"
            values = [0.1, 2]
            """);
    assertEquals("pick.script", plan.program());
    assertEquals(Optional.of("ur10e"), plan.robot());
    assertEquals(Optional.of("cell.json"), plan.scene());
    assertEquals(
        new RunSettings(
            20,
            7,
            true,
            false,
            true,
            List.of("parts"),
            List.of("place"),
            List.of("digital_in[0]=true")),
        plan.settings());
    assertEquals(6, plan.size());
    assertEquals(
        new ParameterTarget.Variable("place", OptionalInt.of(1)),
        plan.parameters().get(1).target());
    assertEquals("variable place[1]", plan.parameters().get(1).name());
  }

  @Test
  void everyMistakeIsToldWithItsPlace() {
    assertEquals(
        List.of(
            "p.toml:2:1: error: there is no robto in the plan, did you mean robot?",
            "p.toml:7:1: error: from is \"slow\", must be a number",
            "p.toml:10:1: error: set is \"sped\", must be " + TargetText.LEGAL,
            "p.toml:3:1: error: time_limit is 0 s, must be 0.002 to 86400.0 s"),
        mistakes(
            """
            program = "pick.script"
            robto = "ur5e"
            time_limit = 0

            [[parameter]]
            set = "speed"
            from = "slow"
            to = 1
            [[parameter]]
            set = "sped"
            """));
  }

  @Test
  void gridNeedsStepsAndTheListAsManyValuesOfEach() {
    String parameters =
        """
        [[parameter]]
        set = "speed"
        from = 0.5
        to = 1
        """;
    assertEquals(
        List.of(
            "p.toml:1:1: error: speed has neither values nor steps, must have one of them for"
                + " grid"),
        mistakes("program = \"a.script\"\n" + parameters));
    assertEquals(
        List.of(
            "p.toml:3:1: error: slider has 1 values, must have 2 as seed has: a list takes the"
                + " first of all, then the second of all"),
        mistakes(
            """
            program = "a.script"
            [sampling]
            method = "list"
            [[parameter]]
            set = "seed"
            values = [1, 2]
            [[parameter]]
            set = "slider"
            values = [0.5]
            """));
  }

  @Test
  void textThatIsNoTomlIsToldWithItsPlace() {
    List<String> mistakes = mistakes("program = \"a.script\"\nrobot = ur5e\n");
    assertTrue(mistakes.getFirst().startsWith("p.toml:2:9: error: "), mistakes.toString());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "speed | MoveFactor[argument=v]",
        "acceleration | MoveFactor[argument=a]",
        "slider | Slider[]",
        "load cog_y | Load[component=2]",
        "base rz | BasePlace[axis=RZ]",
        "feature table x | FeaturePlace[name=table, axis=X]",
        "object big box y | ObjectPlace[name=big box, axis=Y]",
        "input digital_in[3] | InputLevel[signal=digital_in[3]]",
        "input digital_in[3] time | InputTime[signal=digital_in[3]]",
        "argument 12 v | CallArgument[line=12, argument=v]",
        "seed | Seed[]",
        "robot | RobotModel[]"
      })
  void targetsAreWrittenInWords(String text, String target) {
    assertEquals(target, TargetText.parse(text).orElseThrow().toString());
  }

  @ParameterizedTest
  @CsvSource({
    "speeds",
    "load",
    "base w",
    "feature x",
    "variable",
    "variable 3",
    "slider 1",
    "argument 0 v"
  })
  void otherWordsAreNoTargets(String text) {
    assertEquals(Optional.empty(), TargetText.parse(text));
  }
}
