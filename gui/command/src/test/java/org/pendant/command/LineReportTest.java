package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** {@code pendant run --profile}. */
final class LineReportTest {
  private static final String PROGRAM =
      """
      def moves():
        movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], t=2)
        i = 0
        while i < 2:
          movel(pose_add(get_target_tcp_pose(), p[0, 0, 0.1, 0, 0, 0]), a=1, v=0.1)
          sleep(0.5)
          i = i + 1
        end
      end
      """;

  private final ByteArrayOutputStream errors = new ByteArrayOutputStream();

  @TempDir private Path folder;

  @BeforeEach
  void writeProgram() throws IOException {
    Files.writeString(folder.resolve("moves.script"), PROGRAM);
  }

  private ExitCode run(String... words) {
    List<String> line =
        List.of(words).stream()
            .map(word -> word.contains(".") ? folder.resolve(word).toString() : word)
            .toList();
    return new Pendant(new Console(new ByteArrayOutputStream(), errors)).run(line);
  }

  private String complaint() {
    return errors.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aTableHasARowForEachLineThatTookTime() throws IOException {
    assertEquals(
        ExitCode.DONE,
        run("run", "--start-ramp", "off", "--profile", "lines.csv", "moves.script"),
        complaint());

    List<String> rows = Files.readAllLines(folder.resolve("lines.csv"));
    assertEquals(
        "line,executions,time_s,longest_s,share,path_m,tool_speed_m_s,joint_speed,joint_speed_of,"
            + "torque,torque_of,joint_limit_rad,joint_limit_of,plane_m,plane,node,text",
        rows.getFirst());
    assertTrue(rows.get(1).startsWith("2,1,2,2,"), rows.get(1));
    assertTrue(rows.get(2).startsWith("5,2,"), rows.get(2));
    assertTrue(
        rows.get(2)
            .endsWith(
                ",\"movel(pose_add(get_target_tcp_pose(), p[0, 0, 0.1, 0, 0, 0]), a=1, v=0.1)\""),
        rows.get(2));
    assertTrue(rows.get(3).startsWith("6,2,1,0.5,"), rows.get(3));
    String[] move = rows.get(2).split(",", -1);
    assertEquals(0.2, Double.parseDouble(move[5]), 1e-5, "two ways of 0.1 m");
    assertEquals(0.1, Double.parseDouble(move[6]), 1e-5);
  }

  @Test
  void anotherNameMakesATableForPeople() throws IOException {
    assertEquals(ExitCode.DONE, run("run", "--profile", "lines.txt", "moves.script"), complaint());

    List<String> lines = Files.readAllLines(folder.resolve("lines.txt"));
    assertTrue(lines.get(0).endsWith(" s"), lines.get(0));
    assertTrue(lines.get(1).startsWith("line"), lines.get(1));
    assertTrue(lines.get(3).contains("200.0 mm  100 mm/s"), lines.get(3));
  }

  @Test
  void severalProgramsHaveNoProfile() {
    assertEquals(
        ExitCode.WRONG_USAGE, run("run", "--profile", "lines.csv", "moves.script", "moves.script"));
    assertTrue(
        complaint().contains("--profile goes with one program, there are several"), complaint());
  }

  @Test
  void theRecordIsAnotherFile() {
    assertEquals(
        ExitCode.WRONG_USAGE,
        run("run", "--profile", "lines.csv", "--record", "lines.csv", "moves.script"));
    assertTrue(complaint().contains("name the same file"), complaint());
  }
}
