package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** The safety settings of PolyScope's installations hold in headless runs. */
@Tag("slow")
final class PolyScopeSafetyTest {
  private static final String CELL =
      """
      <Installation>
        <SafetySettings>
      [SafetyLimits Normal Values]
      maxTcpSpeed = 1.5
      maxForce = 150.0
      maxElbowSpeed = 1.5
      maxElbowForce = 150.0
      maxStoppingDistance = 0.5
      maxStoppingTime = 0.4
      maxPower = 300.0
      maxMomentum = 25.0

      [SafetyLimits Normal Joints]
      maxJointSpeed = [0.5, 3.3415, 3.3415, 3.3415, 3.3415, 6.4832]
      minJointPosition = [6.23, 6.23, 6.23, 6.23, 6.23, 6.23]
      maxJointPosition = [0.05, 0.05, 0.05, 0.05, 0.05, 0.05]
      minJointRevolutions = [-2, -2, -2, -2, -2, -2]
      maxJointRevolutions = [1, 1, 1, 1, 1, 1]

      [SafetyLimits BoundaryPlane0]
      name = Bench
      displacement = 0.0
      mode = BOTH
      planeNormal = [0.0, 0.0, 1.0]
      distanceToOrigin = -0.4
      elbowRestricted = false

      [SafetyIOConfiguration Inputs]
      reducedModeInputA = 4
      reducedModeInputB = 5
        </SafetySettings>
      </Installation>
      """;

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("cell.installation"), CELL);
    Launcher.script(
        folder,
        "down.script",
        """
        def down():
          textmsg(is_within_safety_limits(get_actual_tcp_pose()))
          below = pose_add(get_actual_tcp_pose(), p[0, 0, -0.2, 0, 0, 0])
          textmsg(is_within_safety_limits(below))
          movel(below)
        end
        """);
    Launcher.script(
        folder,
        "spin.script",
        """
        def spin():
          textmsg("spins")
          while True:
            direct_torque([30, 0, 0, 0, 0, 0])
          end
        end
        """);
  }

  private Result run(String installation, String program) {
    return Launcher.pendant(folder, "run", "--installation", installation, program);
  }

  @Test
  void aPlaneStopsTheProgramThatWouldPassIt() {
    Result result = run("cell.installation", "down.script");
    assertAll(
        () -> assertEquals(1, result.exitCode(), result.errors()),
        () -> assertEquals("True\nFalse\n", result.output(), result.errors()),
        () -> assertTrue(result.errors().contains("C152A0"), result.errors()),
        () -> assertTrue(result.errors().contains("Bench"), result.errors()));
  }

  @Test
  void aSpeedLimitStopsTheProgramThatExceedsIt() {
    Result result = run("cell.installation", "spin.script");
    assertAll(
        () -> assertEquals(1, result.exitCode(), result.errors()),
        () -> assertEquals("spins\n", result.output()),
        () -> assertTrue(result.errors().contains("C191A1"), result.errors()),
        () -> assertTrue(result.errors().contains("limit 0.5 rad/s"), result.errors()));
  }

  @Test
  void convertedTheyHoldAsWell() {
    Result converted = Launcher.pendant(folder, "convert", "cell.installation", "cell.pinst");
    assertEquals(0, converted.exitCode(), converted.errors());
    assertTrue(run("cell.pinst", "down.script").errors().contains("Bench"));
    assertTrue(run("cell.pinst", "spin.script").errors().contains("limit 0.5 rad/s"));
  }

  @Test
  void whatIsNotModelledAndWhatTheArmCannotDoIsTold() {
    Result result = run("cell.installation", "down.script");
    for (String told :
        List.of(
            "cell.installation: note: line 29: reducedModeInputA in [SafetyIOConfiguration Inputs]"
                + " gives reducedModeInput to configurable_in[4] and configurable_in[5], which is"
                + " not modelled: the safety input reduced_mode demands it",
            "cell.installation: note: the reduced limits lack maxPower",
            "safety.normal.jointSpeedRadPerS: joint 5 may turn at 6.4832 rad/s, must be at most")) {
      assertTrue(result.errors().contains(told), () -> told + "\n" + result.errors());
    }
  }
}
