package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;

/** {@code --installation FILE} sets a headless controller up. */
@Tag("slow")
final class InstallationTest {
  private static final String CELL =
      """
      pendant installation 1
      robot id="ur10e"
      tool name="Gripper" in-flange=[0, 0, 0.25, 0, 0, 0]
      active-tool name="Gripper"
      payload name="Box" mass-kg=2.5 cog-m=[0, 0, 0.1] inertia-kg-m2=[0, 0, 0, 0, 0, 0]
      active-payload name="Box"
      mounting tilt-rad=3.141592653589793 rotation-rad=0
      signal id="digital_out[3]" output=high-when-running
      """;

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("cell.pinst"), CELL);
    Launcher.script(
        folder,
        "asks.script",
        """
        def asks():
          textmsg(get_tcp_offset())
          textmsg(pose_trans(pose_inv(get_target_tcp_pose()), get_target_tcp_pose()))
          textmsg(get_target_payload())
          textmsg(get_target_payload_cog())
          textmsg(get_gravity()[2])
          textmsg(get_standard_digital_out(3))
        end
        """);
  }

  @Test
  void aRunBeginsAsTheFileSays() {
    Result result = Launcher.pendant(folder, "run", "--installation", "cell.pinst", "asks.script");
    assertEquals(
        "p[0, 0, 0.25, 0, 0, 0]\np[0, 0, 0, 0, 0, 0]\n2.5\n[0, 0, 0.1]\n-9.82\nTrue\n",
        result.output(),
        result.errors());
    assertEquals(0, result.exitCode());
  }

  @Test
  void aProgramTreeHasItsFeaturesAndVariablesFromTheFileThatItNames() throws IOException {
    Files.writeString(
        folder.resolve("cell.pinst"),
        CELL
            + """
            feature name="table" kind=plane
              point pose=[0.5, 0, 0.1, 0, 0, 0]
              point pose=[0.5, 1, 0.1, 0, 0, 0]
              point pose=[0, 0, 0.1, 0, 0, 0]
            variable name="count" value="12"
            """);
    Files.writeString(
        folder.resolve("asks.pendant"),
        """
        pendant program 1
        installation file="cell"
        main
          script-line code="textmsg(get_tcp_offset())"
          script-line code="textmsg(table)"
          script-line code="count = count + 1"
          script-line code="textmsg(count)"
        """);
    Result result = Launcher.pendant(folder, "run", "asks.pendant");
    assertEquals(
        "p[0, 0, 0.25, 0, 0, 0]\np[0.5, 0, 0.1, 0, 0, 1.570796]\n13\n",
        result.output(),
        result.errors());
  }

  @Test
  void anInstallationForAnotherArmIsRefused() {
    Result result =
        Launcher.pendant(
            folder, "run", "--robot", "ur5e", "--installation", "cell.pinst", "asks.script");
    assertEquals(2, result.exitCode());
    assertTrue(
        result
            .errors()
            .contains("the installation cannot be used: robot: it is for UR10e, the arm is UR5e"),
        result.errors());
  }

  @Test
  void mistakesAreToldWithLineAndColumn() throws IOException {
    Files.writeString(folder.resolve("odd.pinst"), CELL + "transition hardness=soft\n");
    Result result = Launcher.pendant(folder, "run", "--installation", "odd.pinst", "asks.script");
    assertEquals(2, result.exitCode());
    assertTrue(
        result.errors().contains("odd.pinst:9:21: hardness is soft, must be a number such as 0.25"),
        result.errors());
    Result missing = Launcher.pendant(folder, "serve", "--installation", "no.pinst");
    assertEquals(2, missing.exitCode());
    assertTrue(missing.errors().contains("no.pinst: there is no such file"), missing.errors());
  }
}
