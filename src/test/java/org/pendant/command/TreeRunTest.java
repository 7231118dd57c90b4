package org.pendant.command;

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

/** Program trees as whole files: run, check, convert and record. */
@Tag("slow")
final class TreeRunTest {
  private static final String CELL =
      """
      pendant installation 1
      tool name="Gripper" in-flange=[0, 0, 0.25, 0, 0, 0]
      active-tool name="Gripper"
      """;

  /** Goes somewhere, counts, and says what has come of it. */
  private static final String PROGRAM =
      """
      pendant program 1
      position name="Above" tcp=[0.4, -0.2, 0.5, 3.14, 0, 0] feature="Base" \
      joints-rad=[0, -1.5, -1.5, -1.5, 1.5, 0] tool-in-flange=[0, 0, 0, 0, 0, 0]
      main forever=false
        move kind=joint speed=1 acceleration=1.4 tool=active feature="Base" by-joints=true
          waypoint target=fixed name="Above" timing=as-move
        assignment variable="count" expression="0"
        loop rule=times count="3"
          assignment variable="count" expression="count + 1"
        if condition="count == 3"
          script-line code="textmsg(get_target_joint_positions())"
        else
          halt
        script-line code="textmsg(get_tcp_offset())"
      """;

  private static final String AT = "[0, -1.5, -1.5, -1.5, 1.5, 0]\n";

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    Files.writeString(folder.resolve("cell.pinst"), CELL);
    Files.writeString(folder.resolve("go.pendant"), PROGRAM);
  }

  private String text(String name) throws IOException {
    return Files.readString(folder.resolve(name));
  }

  private void assertDone(Result result) {
    assertEquals(0, result.exitCode(), result.errors());
  }

  @Test
  void runsInTheInstallationOfTheCommandLine() {
    Result bare = Launcher.pendant(folder, "run", "go.pendant");
    assertEquals(AT + "p[0, 0, 0, 0, 0, 0]\n", bare.output(), bare.errors());
    Result result = Launcher.pendant(folder, "run", "--installation", "cell.pinst", "go.pendant");
    assertEquals(AT + "p[0, 0, 0.25, 0, 0, 0]\n", result.output(), result.errors());
    assertDone(result);
  }

  @Test
  void becomesAUrpThatRunsAndComesBackAsItWas() throws IOException {
    assertDone(Launcher.pendant(folder, "convert", "go.pendant", "go.urp"));
    byte[] urp = Files.readAllBytes(folder.resolve("go.urp"));
    assertEquals(List.of((byte) 0x1f, (byte) 0x8b), List.of(urp[0], urp[1]), "packed by gzip");
    Result run = Launcher.pendant(folder, "run", "--installation", "cell.pinst", "go.urp");
    assertEquals(AT + "p[0, 0, 0.25, 0, 0, 0]\n", run.output(), run.errors());
    assertDone(run);
    assertDone(Launcher.pendant(folder, "convert", "go.urp", "again.pendant"));
    assertDone(Launcher.pendant(folder, "convert", "again.pendant", "again.urp"));
    assertDone(Launcher.pendant(folder, "convert", "again.urp", "third.pendant"));
    assertEquals(text("again.pendant"), text("third.pendant"));
    Result again = Launcher.pendant(folder, "run", "again.pendant");
    assertEquals(AT + "p[0, 0, 0, 0, 0, 0]\n", again.output(), again.errors());
  }

  @Test
  void whatIsIncompleteIsToldByItsLineAndDoesNotRun() throws IOException {
    Files.writeString(folder.resolve("go.pendant"), PROGRAM.replace("\"count == 3\"", "\"\""));
    for (String command : List.of("check", "run")) {
      Result result = Launcher.pendant(folder, command, "go.pendant");
      assertEquals(3, result.exitCode(), command);
      assertEquals("", result.output());
      assertTrue(
          result
              .errors()
              .contains(
                  "go.pendant:9: error: condition: the condition is missing, expected an"
                      + " expression"),
          result.errors());
    }
  }

  @Test
  void whatIsSuppressedMayBeIncomplete() throws IOException {
    Files.writeString(
        folder.resolve("go.pendant"),
        PROGRAM
            + """
              suppressed if condition=""
                move kind=linear speed=-1 acceleration=1.2 tool=active feature="nowhere"
                  waypoint target=fixed name="Never" timing=as-move
            """);
    assertDone(Launcher.pendant(folder, "check", "go.pendant"));
    assertDone(Launcher.pendant(folder, "convert", "go.pendant", "go.urp"));
    for (String file : List.of("go.pendant", "go.urp")) {
      Result result = Launcher.pendant(folder, "run", file);
      assertEquals(AT + "p[0, 0, 0, 0, 0, 0]\n", result.output(), result.errors());
      assertDone(result);
    }
  }

  @Test
  void aRecordingBecomesATable() throws IOException {
    assertDone(Launcher.pendant(folder, "run", "--record", "go.rec", "go.pendant"));
    assertDone(Launcher.pendant(folder, "convert", "go.rec", "go.csv"));
    assertDone(Launcher.pendant(folder, "run", "--record", "direct.csv", "go.pendant"));
    List<String> rows = text("go.csv").lines().toList();
    assertEquals(text("direct.csv").lines().findFirst().orElseThrow(), rows.getFirst());
    String last = rows.getLast();
    assertTrue(last.split(",", -1)[2].startsWith("-1.5"), last);
  }
}
