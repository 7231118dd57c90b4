package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.command.Launcher.Result;

/** Moves as a user at the command line meets them. */
@Tag("slow")
final class MotionRunTest {
  private static final String READY = "  movej([0, -1.57, -1.57, -1.57, 1.57, 0])\n";

  @TempDir Path folder;

  private Result run(String text, String... options) {
    Launcher.script(folder, "move.script", text);
    String[] words = new String[options.length + 2];
    words[0] = "run";
    words[1] = "move.script";
    System.arraycopy(options, 0, words, 2, options.length);
    return Launcher.pendant(folder, words);
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          movej(p[2, 0, 0, 0, 0, 0])                 | p[2, 0, 0, 0, 0, 0] is out of reach
          movej([7, -1.57, -1.57, -1.57, 1.57, 0])   | q[0] (base) is 7 rad, must be
          movej([1, 0, 0, 0, 0, 0], a=0)             | a is 0 rad/s², must be above 0
          movej([1, 0, 0, 0, 0, 0], v=-1)            | v is -1 rad/s, must be above 0
          movel(p[0.4, 0, 0.4, 3.14, 0, 0], t=-1)    | t is -1 s, must not be negative
          movel(p[0.4, 0, 0.4, 3.14, 0, 0], r=-1)    | r is -1 m, must not be negative
          """)
  void whatCannotBeDoneIsAnErrorWithCausePlaceAndGoal(String call, String expected) {
    Result result = run("def move():\n" + READY + "  " + call + "\nend\n");
    List<String> errors = result.errors().lines().toList();
    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertTrue(errors.getFirst().startsWith("move.script:3:3: error: move"), call),
        () -> assertTrue(errors.getFirst().contains(expected), result.errors()),
        () -> assertEquals("  " + call, errors.get(1)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          movel(p[1.4, 0, 0.4, 3.14, 0, 0], r=0.02)  | C154A0 | the tool must stay nearer
          movel(p[10, 0, 0, 0, 0, 0])                | C154A0 | the elbow is straight
          movel(p[10, 0, 0, 0, 0, 0], t=2)           | C154A0 | on the way to p[10, 0, 0, 0, 0, 0]
          movep(p[0, 0.05, 0.3, 3.14, 0, 0])         | C154A0 | too close to a singularity
          movel(p[-0.492, 0.133, 0.488, -2.22, 2.22, 0]) | C154A0 | singularity
          movel(p[-0.492, 0.133, 0.488, -2.22, 2.22, 0]) | C154A0 | way to p[-0.492, 0.133, 0.488, -2.22, 2.22, 0]
          """)
  void whereTheArmCannotGoOnAProtectiveStopSaysWhy(String call, String code, String expected) {
    Result result = run("def move():\n" + READY + "  " + call + "\n  textmsg(1)\nend\n");
    List<String> errors = result.errors().lines().toList();
    assertAll(
        () -> assertEquals(1, result.exitCode()),
        () -> assertEquals("", result.output()),
        () -> assertEquals(1, errors.size(), "told once: " + result.errors()),
        () ->
            assertTrue(
                errors
                    .getFirst()
                    .startsWith(
                        "move.script: error: stopped in line 3: " + code + " protective stop"),
                result.errors()),
        () -> assertTrue(errors.getFirst().contains(expected), result.errors()));
  }

  @Test
  void aJointThatReachesTheEndOfItsRangeIsNamed() {
    Result result =
        run(
            """
            def move():
              movej([6.2, -1.57, -1.57, -1.57, 1.57, 0], v=3, a=10)
              movel(pose_trans(p[0, 0, 0, 0, 0, 0.4], get_target_tcp_pose()))
            end
            """);
    assertEquals(1, result.exitCode());
    String error = result.errors().lines().findFirst().orElseThrow();
    assertTrue(
        error.startsWith("move.script: error: stopped in line 3: C150A0 protective stop"), error);
    assertTrue(error.contains("base (joint 0) comes too close to its position limit"), error);
  }

  @Test
  void theRecordOfABlendedPathEndsInTheLastWaypoint() throws IOException {
    Result result =
        run(
            "def move():\n"
                + READY
                + """
                  movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0], r=0.02)
                  textmsg("blend")
                  movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0], r=0.05)
                  textmsg("last")
                end
                """,
            "--record",
            "path.csv");
    assertEquals("blend\nlast\n", result.output(), result.errors());
    List<String> rows = Files.readAllLines(folder.resolve("path.csv"));
    List<String> names = List.of(rows.getFirst().split(",", -1));
    String[] last = rows.getLast().split(",", -1);
    assertEquals(0.15, Double.parseDouble(last[names.indexOf("target_tcp_1")]), 1e-9);
    assertEquals(0, Double.parseDouble(last[names.indexOf("target_qd_0")]), 0);
  }

  @Test
  void overlappingBlendsAreReportedInVersion1AndMadeSmallerInVersion2() {
    String moves =
        READY
            + """
              movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0], r=0.06)
              movel(p[0.45, -0.05, 0.45, 2.2214, -2.2214, 0], r=0.06)
              movel(p[0.55, 0.05, 0.45, 2.2214, -2.2214, 0])
            end
            """;
    Result first = run("def move():\n" + moves);
    Result second = run("def move():\n  motion_version_set(2)\n" + moves);
    assertAll(
        () -> assertEquals(0, first.exitCode(), first.errors()),
        () -> assertTrue(first.errors().contains("Overlapping Blends: movel"), first.errors()),
        () -> assertEquals(0, second.exitCode(), second.errors()),
        () -> assertEquals("", second.errors()));
  }
}
