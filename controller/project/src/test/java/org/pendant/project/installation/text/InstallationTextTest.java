package org.pendant.project.installation.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.RandomInstallations;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.text.TextProblem;

class InstallationTextTest {
  private static final String HEADING = "pendant installation 1\n";

  private static Installation whole(String lines) {
    ReadInstallation read = InstallationText.read(HEADING + lines);
    assertEquals(List.of(), read.problems());
    return read.installation();
  }

  private static TextProblem problem(String lines) {
    List<TextProblem> problems = InstallationText.read(HEADING + lines).problems();
    assertEquals(1, problems.size(), problems::toString);
    return problems.getFirst();
  }

  @Test
  void everyInstallationIsReadBackAsItWas() {
    for (int seed = 0; seed < 1000; seed++) {
      Installation written = new RandomInstallations(seed).next();
      String text = InstallationText.write(written);
      ReadInstallation read = InstallationText.read(text);
      int number = seed;
      assertEquals(List.of(), read.problems(), () -> "seed " + number + "\n" + text);
      assertEquals(written, read.installation(), () -> "seed " + number + "\n" + text);
      assertEquals(text, InstallationText.write(read.installation()), () -> "seed " + number);
    }
  }

  @Test
  void anInstallationWithoutAnythingHasAShortText() {
    assertEquals(
        """
        pendant installation 1
        mounting tilt-rad=0 rotation-rad=0
        analog in=[voltage, voltage] out=[current, current] tool-in=[voltage, voltage]
        tool-connector voltage-v=0 outputs=digital pins=[sinking, sinking]
        tool-communication baud-rate=115200 parity=none stop-bits=1 rx-idle-chars=1.5 \
        tx-idle-chars=3.5
        home joints-rad=[0, -1.5707963267948966, -1.5707963267948966, -1.5707963267948966, \
        1.5707963267948966, 0]
        transition hardness=1
        """,
        InstallationText.write(Installation.NONE));
  }

  @Test
  void whatIsLeftOutIsAsInNoInstallation() {
    assertEquals(Installation.NONE, whole("\n"));
  }

  @Test
  void linesMayStandInAnyOrder() {
    Installation read =
        whole(
            """
            active-tool name="Gripper"
            signal id="digital_out[2]" name="Valve" output=high-when-running
            tool name="Gripper" in-flange=[0, 0, 0.12, 0, 0, 0]
            """);
    assertEquals(new Pose(0, 0, 0.12, 0, 0, 0), read.activeToolInFlange());
    assertEquals(RunStateAction.HIGH_WHEN_RUNNING, read.signals().getFirst().output());
  }

  @Test
  void externalControlIsWrittenWhereItAsksAnotherHost() {
    Installation other =
        Installation.NONE.with(parts -> parts.controlHost = new ControlHost("pc.local", 50012));
    assertTrue(
        InstallationText.write(other).contains("external-control host=\"pc.local\" port=50012\n"));
    assertEquals(other, whole("external-control host=\"pc.local\" port=50012\n"));
  }

  @Test
  void pointsBelongToTheFeatureAboveThem() {
    Installation read =
        whole(
            """
            feature name="edge" kind=line joggable=true
              point pose=[0, 0, 0, 0, 0, 0]
              point pose=[0, 1, 0, 0, 0, 0]
            """);
    assertEquals(
        Optional.of(
            new Feature(
                "edge",
                FeatureKind.LINE,
                List.of(Pose.ZERO, new Pose(0, 1, 0, 0, 0, 0)),
                false,
                true)),
        read.feature("edge"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "tools name=\"a\"|1|tools is no such line",
        "tool name=\"a\"|1|tool: the field in-flange is missing",
        "tool name=\"a\" in-flange=[1, 2]|25|in-flange has 2 numbers, must have 6",
        "tool name=a in-flange=[0, 0, 0, 0, 0, 0]|11|name must be a text in quotes",
        "transition hardness=soft|21|hardness is soft, must be a number such as 0.25",
        "transition hardness=1 speed=2|29|transition has no field speed, it may have hardness",
        "transition hardness=1e999|21|hardness is 1e999, must be a number such as 0.25",
        "transition hardness=NaN|21|hardness is NaN, must be a number such as 0.25",
        "ethernet-ip on-loss=halt|21|on-loss is halt, must be one of ignore, pause, stop",
        "# my cell|1|a remark cannot be kept",
        "'  point pose=[0, 0, 0, 0, 0, 0]'|3|point: a line that begins with two blanks",
        "' robot id=\"ur5e\"'|1|the line must begin at the left edge",
        "robot id=\"ur5e|10|the closing quote is missing",
        "tool-communication baud-rate=100 parity=none stop-bits=1 rx-idle-chars=2"
            + " tx-idle-chars=2|1|baud rate is 100",
      })
  void saysWhereAndWhatIsWrong(String line, int column, String message) {
    TextProblem problem = problem(line + "\n");
    assertEquals(2, problem.line());
    assertEquals(column, problem.column(), problem.message());
    assertTrue(problem.message().startsWith(message), problem::message);
  }

  @Test
  void refusesWhatIsSaidTwice() {
    TextProblem problem = problem("transition hardness=1\ntransition hardness=0\n");
    assertEquals(3, problem.line());
    assertEquals("transition: line 2 says that already", problem.message());
  }

  @Test
  void refusesAPointTooMuch() {
    String point = "  point pose=[0, 0, 0, 0, 0, 0]\n";
    TextProblem problem = problem("feature name=\"a\" kind=point\n" + point + point);
    assertEquals(4, problem.line());
    assertEquals("point: a point has 1 points, this is one more", problem.message());
  }

  @Test
  void continuesAfterWhatIsWrong() {
    ReadInstallation read =
        InstallationText.read(
            HEADING
                + "feature name=\"a\" kind=cube\n"
                + "  point pose=[0, 0, 0, 0, 0, 0]\n"
                + "tool in-flange=[]\n"
                + "robot id=\"ur3e\"\n");
    assertEquals(List.of(2, 4), read.problems().stream().map(TextProblem::line).toList());
    assertEquals("ur3e", read.installation().robot());
  }

  @Test
  void refusesSafetyThatIsNotWhole() {
    String text =
        InstallationText.write(withSafety(SafetyConfiguration.standard(ArmLibrary.load("ur5e"))));
    String without = text.replaceFirst("  normal tool-force-n=.*\n", "");
    ReadInstallation read = InstallationText.read(without);
    assertEquals(
        "safety: the line   normal tool-force-n=... is missing, every limit must be given",
        read.problems().getFirst().message());
    assertEquals(Optional.empty(), read.installation().safety());
  }

  @Test
  void refusesReducedLimitsThatAreWiderThanTheNormalOnes() {
    String text =
        InstallationText.write(withSafety(SafetyConfiguration.standard(ArmLibrary.load("ur5e"))));
    ReadInstallation read =
        InstallationText.read(text.replaceFirst("reduced power-w=.*", "reduced power-w=9000"));
    assertTrue(
        read.problems().getFirst().message().startsWith("safety: reduced limits: power is 9000"),
        () -> read.problems().toString());
  }

  @Test
  void refusesOtherTexts() {
    ReadInstallation read = InstallationText.read("def f():\n");
    assertEquals(
        new TextProblem(1, 1, "the first line must be: pendant installation 1"),
        read.problems().getFirst());
  }

  @Test
  void refusesEndlessTexts() {
    ReadInstallation read = InstallationText.read("x".repeat(5_000_000));
    assertEquals(
        List.of(
            new TextProblem(1, 1, "the text has 5000000 characters, must have at most 4194304")),
        read.problems());
    assertEquals(100, InstallationText.read(HEADING + "x\n".repeat(1000)).problems().size());
  }

  private static Installation withSafety(SafetyConfiguration safety) {
    return Installation.NONE.withSafety(Optional.of(safety));
  }
}
