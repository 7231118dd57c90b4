package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;

/** Which arm runs a program, and how it starts. */
@Tag("slow")
final class ArmOptionsTest {
  /** Half of a frame. */
  private static final double HALF_FRAME_S = 0.001;

  @TempDir Path folder;

  private void ownArm(String name, String what, String instead) throws IOException {
    String text = ArmFile.text(ArmLibrary.load("ur10e"));
    assertTrue(text.contains(what), text);
    Files.writeString(folder.resolve(name), text.replace(what, instead));
  }

  @Test
  void programRunsOnTheArmOfAFile() throws IOException {
    ownArm("mine.json", "\"rotorInertiaKgM2\" : 6.03", "\"rotorInertiaKgM2\" : 7");
    Launcher.script(
        folder,
        "say.script",
        """
        q = [0, -1.5, 1, 0, 0, 0]
        textmsg(get_mass_matrix(q, True)[0, 0] - get_mass_matrix(q, False)[0, 0])
        textmsg(get_forward_kin([0, 0, 0, 0, 0, 0])[0] < -1)
        """);

    Result result = Launcher.pendant(folder, "run", "--robot", "mine.json", "say.script");

    assertAll(
        () -> assertEquals("", result.errors()),
        () -> assertEquals(0, result.exitCode()),
        () -> assertEquals(7, Double.parseDouble(result.outputLines().getFirst()), 1e-6),
        () -> assertEquals("True", result.outputLines().getLast()));
  }

  @Test
  void anArmFileThatIsNoneIsRefusedWithItsPlace() throws IOException {
    ownArm("mine.json", "\"id\" : \"ur10e\"", "\"id\" : \"ur11e\"");
    Launcher.script(folder, "say.script", "textmsg(1)\n");

    Result result = Launcher.pendant(folder, "run", "--robot", "mine.json", "say.script");

    assertAll(
        () -> assertEquals(2, result.exitCode()),
        () -> assertEquals("", result.output()),
        () ->
            assertTrue(
                result.errors().startsWith("pendant run: mine.json:2:10: id is \"ur11e\", must be"),
                result.errors()));
  }

  @Test
  void withoutTheStartRampAMoveIsDoneEarlier() throws IOException {
    Launcher.script(
        folder,
        "move.script",
        "def move():\n  movej([0.4, -1.5, -1.5, -1.5, 1.5, 0], a=2, v=1)\nend\n");
    // counted in frames: a table has a row for each
    double rampedS = endS(Launcher.pendant(folder, run("ramped.csv", "on")), "ramped.csv");
    double bareS = endS(Launcher.pendant(folder, run("bare.csv", "off")), "bare.csv");

    assertEquals(0.081, rampedS - bareS, 2 * HALF_FRAME_S);
  }

  private static String[] run(String table, String ramp) {
    return new String[] {"run", "--start-ramp", ramp, "--record", table, "move.script"};
  }

  private double endS(Result result, String table) throws IOException {
    assertEquals(0, result.exitCode(), result.errors());
    String last = Files.readAllLines(folder.resolve(table)).getLast();
    return Double.parseDouble(last.substring(0, last.indexOf(',')));
  }
}
