package org.pendant.project.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.installation.text.ReadInstallation;

class InstallationCheckTest {
  private static final ArmDescription UR5E = ArmLibrary.load("ur5e");

  /** What stands for a whole feature in the lines of tests. */
  private static final String TABLE =
      "feature name=\"table\" kind=point\n  point pose=[0, 0, 0, 0, 0, 0]\n";

  private static List<InstallationProblem> problems(String lines) {
    ReadInstallation read =
        InstallationText.read("pendant installation 1\n" + lines.replace("\\n", "\n") + "\n");
    assertEquals(List.of(), read.problems());
    return InstallationCheck.problems(read.installation(), UR5E);
  }

  @Test
  void findsNothingInAGoodOne() {
    assertEquals(List.of(), InstallationCheck.problems(Installation.NONE, UR5E));
    assertEquals(
        List.of(),
        problems(
            """
            robot id="ur5e"
            tool name="Gripper" in-flange=[0, 0, 0.12, 0, 0, 0]
            active-tool name="Gripper"
            payload name="Box" mass-kg=1.5 cog-m=[0, 0, 0.1] inertia-kg-m2=[0, 0, 0, 0, 0, 0]
            active-payload name="Box"
            mounting tilt-rad=3.141592653589793 rotation-rad=0
            signal id="digital_in[0]" name="Part there" input=freedrive
            signal id="analog_out[1]" output=high-when-running
            signal id="output_boolean_register[64]" output=high-with-power
            variable name="count" value="12"
            variable name="places" value="[p[0, 0, 0, 0, 0, 0]]"
            start-up program="cell.pendant" start-input="digital_in[1]" power-input="tool_in[0]"
            conveyor number=1 encoder=0 feature="table" ticks-per-unit=4000 decoder=1 inputs=[8, 9]
            modbus name="lamp" device="127.0.0.1:1502" unit=1 kind=digital-output address=0 \
            update-hz=10
            """
                + TABLE));
  }

  @Test
  void theExampleOfTheDocumentationIsGood() throws IOException {
    String page = Files.readString(Path.of("..", "..", "docs", "installations.md"));
    String fence = "```pinst\n";
    int begin = page.indexOf(fence) + fence.length();
    String example = page.substring(begin, page.indexOf("```", begin));
    ReadInstallation read = InstallationText.read(example);
    assertEquals(List.of(), read.problems());
    assertEquals(List.of(), InstallationCheck.problems(read.installation(), UR5E));
    assertEquals(example, InstallationText.write(read.installation()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "robot id=\"ur3e\"|robot|it is for UR3e, the arm is UR5e",
        "tool name=\" \" in-flange=[0, 0, 0, 0, 0, 0]|tools[0].name|there is no name",
        "tool name=\"a\" in-flange=[0, 0, 0, 0, 0, 0]\\n"
            + "tool name=\"a\" in-flange=[0, 0, 0, 0, 0, 0]|tools[1].name|a is the name of another"
            + " one too",
        "tool name=\"a\" in-flange=[0, 0, 9, 0, 0, 0]|tools[0].inFlange|the position must be -4.0",
        "active-tool name=\"b\"|activeTool|there is no TCP b",
        "payload name=\"a\" mass-kg=500 cog-m=[0, 0, 0] inertia-kg-m2=[0, 0, 0, 0, 0, 0]"
            + "|payloads[0].massKg|the mass is 500.0 kg, must be 0 to 20.0 kg on UR5e",
        "payload name=\"a\" mass-kg=1 cog-m=[0, 0, 0] inertia-kg-m2=[-1, 0, 0, 0, 0, 0]"
            + "|payloads[0].inertia|the inertia is refused: the first three",
        "active-payload name=\"b\"|activePayload|there is no payload b",
        "mounting tilt-rad=10 rotation-rad=0|mounting.tiltRad|the angle is 10.0 rad",
        "signal id=\"digital_in[8]\"|signals[0].signal|there is no signal digital_in[8]",
        "signal id=\"flag[1]\"\\n"
            + "signal id=\"flag[1]\"|signals[1].signal|flag[1] is mentioned twice",
        "signal id=\"digital_out[1]\" input=freedrive|signals[0].input|digital_out[1] is no"
            + " digital",
        "signal id=\"flag[1]\" output=high-with-power|signals[0].output|flag[1] is no output",
        "tool-connector voltage-v=5 outputs=digital pins=[sinking, sinking]|wiring.toolVoltage"
            + "|it is 5 V, must be 0, 12 or 24 V",
        "feature name=\"my table\" kind=point\\n  point pose=[0, 0, 0, 0, 0, 0]|features[0].name"
            + "|the name is \"my table\", must be letters",
        "feature name=\"while\" kind=point\\n  point pose=[0, 0, 0, 0, 0, 0]|features[0].name"
            + "|the name is \"while\", must be letters",
        "home joints-rad=[0, 0, 0, 0, 0, 99]|homeRad|home is",
        "variable name=\"a\" value=\"1 +\"|variables[0].value|the value is 1 +: ",
        "variable name=\"a\" value=\"1\\tb\"|variables[0].value|the value has a line end",
        "variable name=\"a\" value=\"\"|variables[0].value|there is no value",
        "variable name=\"a-b\" value=\"1\"|variables[0].name|the name is \"a-b\"",
        "start-up start-input=\"digital_out[1]\"|startUp.startInput|it is digital_out[1]",
        "start-up program=\"cell.txt\"|startUp.program|it is cell.txt",
        "conveyor number=3 encoder=0 feature=\"\" ticks-per-unit=1 decoder=0 inputs=[]"
            + "|conveyors[0].number|it is 3, must be 1 or 2",
        "modbus name=\"a\" device=\"b:0\" unit=1 kind=digital-input address=0 update-hz=10"
            + "|modbus[0].device|it is \"b:0\", must have a port",
        "modbus name=\"a\" device=\"b\" unit=256 kind=digital-input address=0 update-hz=10"
            + "|modbus[0].unit|it is 256, must be 0 to 255",
        "external-control host=\"\" port=50002|controlHost|the host is \"\", must be the name",
        "external-control host=\"pc\" port=0|controlHost|the port is 0, must be 1 to 65535",
        "transition hardness=0.5|transitionHardness|it is 0.5, must be 0 (hard) or 1 (soft)",
      })
  void saysWhichFieldIsWrong(String lines, String field, String message) {
    InstallationProblem first = problems(lines).getFirst();
    assertEquals(field, first.field());
    assertTrue(first.message().startsWith(message), first::message);
    assertTrue(first.blocks());
  }

  @Test
  void requiresTheInputsThatADecoderNeeds() {
    String conveyor = "conveyor number=1 encoder=0 feature=\"table\" ticks-per-unit=1 decoder=";
    for (String wrong :
        List.of("0 inputs=[1]", "1 inputs=[8]", "1 inputs=[8, 8]", "2 inputs=[]", "4 inputs=[5]")) {
      List<InstallationProblem> problems = problems(TABLE + conveyor + wrong);
      assertEquals("conveyors[0].inputs", problems.getFirst().field(), wrong);
    }
    assertEquals(
        "conveyors[0].decoder", problems(TABLE + conveyor + "5 inputs=[]").getFirst().field());
  }

  @Test
  void featuresThatAreNotFinishedKeepNobodyFromWorking() {
    List<InstallationProblem> problems =
        problems(
            """
            feature name="open" kind=plane
              point pose=[0, 0, 0, 0, 0, 0]
            feature name="flat" kind=line
              point pose=[0, 0, 0, 0, 0, 0]
              point pose=[0, 0, 0, 0, 0, 0]
            """);
    assertEquals(
        List.of(
            new InstallationProblem(
                "features[0].points", "open has 1 of the 3 points that it needs", false),
            new InstallationProblem(
                "features[1].points",
                "flat has its points in one place, must give a direction",
                false)),
        problems);
  }

  @Test
  void variablesAndFeaturesShareTheirNames() {
    assertEquals(
        "variables[0].name",
        problems(TABLE + "variable name=\"table\" value=\"1\"").getFirst().field());
  }

  @Test
  void limitsBeyondTheArmAreToldAndKeepNobodyFromWorking() {
    Installation own =
        Installation.NONE.withSafety(Optional.of(SafetyConfiguration.standard(UR5E)));
    assertEquals(Optional.empty(), InstallationCheck.refusal(own, UR5E));
    Installation faster =
        Installation.NONE.withSafety(
            Optional.of(SafetyConfiguration.standard(ArmLibrary.load("ur3e"))));
    InstallationProblem problem = InstallationCheck.problems(faster, UR5E).getFirst();
    assertFalse(problem.blocks());
    assertEquals("safety.normal.jointSpeedRadPerS", problem.field());
    assertTrue(problem.message().startsWith("joint 3 may turn at "), problem::message);
  }
}
