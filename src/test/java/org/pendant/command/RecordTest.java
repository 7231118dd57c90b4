package org.pendant.command;

import static java.nio.file.StandardWatchEventKinds.ENTRY_CREATE;
import static java.nio.file.StandardWatchEventKinds.ENTRY_MODIFY;
import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.WatchKey;
import java.nio.file.WatchService;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.command.Launcher.Result;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingFile;

/** {@code pendant run --record}. */
@Tag("slow")
final class RecordTest {
  private static final int RUNS = 10;
  private static final int KILLS = 4;

  @TempDir Path folder;

  /** Moves, threads, random numbers and outputs: whatever could differ from run to run. */
  @BeforeEach
  void writeProgram() {
    Launcher.script(
        folder,
        "busy.script",
        """
        def busy():
          thread blink():
            while True:
              set_standard_digital_out(0, not get_standard_digital_out(0))
              sleep(0.01)
            end
          end
          run blink()
          home = [0, -1.5708, -1.5708, -1.5708, 1.5708, 0]
          movej(home)
          there = home + [random(), 0, 0, 0, 0, random()]
          movej(there, a=3, v=2)
          movel(pose_add(get_actual_tcp_pose(), p[0, 0, -0.1, 0, 0, 0]), v=0.5)
          textmsg(get_actual_tcp_pose())
        end
        """);
  }

  private static List<String> header() {
    List<String> columns = new ArrayList<>(List.of("time_s"));
    for (String group :
        List.of("target_q", "target_qd", "actual_q", "actual_qd", "target_tcp", "actual_tcp")) {
      for (int i = 0; i < 6; i++) {
        columns.add(group + "_" + i);
      }
    }
    columns.add("line");
    return columns;
  }

  @Test
  void recordHasARowEachFrameUnderTheAgreedHeader() throws IOException {
    Result result = Launcher.pendant(folder, "run", "--record", "out.csv", "busy.script");

    assertEquals(0, result.exitCode(), result.errors());
    List<String> lines = Files.readAllLines(folder.resolve("out.csv"));
    assertEquals(header(), List.of(lines.getFirst().split(",", -1)));
    List<double[]> rows = new ArrayList<>();
    for (String line : lines.subList(1, lines.size())) {
      String[] fields = line.split(",", -1);
      double[] row = new double[fields.length];
      for (int i = 0; i < row.length; i++) {
        row[i] = Double.parseDouble(fields[i]);
      }
      rows.add(row);
    }
    assertTrue(rows.size() > 500, rows.size() + " rows");
    for (int i = 0; i < rows.size(); i++) {
      assertEquals(header().size(), rows.get(i).length);
      if (i > 0) {
        assertEquals(0.002, rows.get(i)[0] - rows.get(i - 1)[0], 1e-9, "row " + i);
      }
    }
    double[] last = rows.getLast();
    for (int joint = 0; joint < 6; joint++) {
      assertEquals(0, last[7 + joint], 1e-9, "the arm is at rest in the end");
    }
    assertTrue(rows.stream().anyMatch(row -> row[37] == 12), "the line of the second movej");
  }

  @Test
  void tenRunsGiveTheSameRecordByteForByte() throws IOException {
    Result first = Launcher.pendant(folder, "run", "--record", "0.csv", "busy.script");
    byte[] expected = Files.readAllBytes(folder.resolve("0.csv"));
    for (int i = 1; i < RUNS; i++) {
      String name = i + ".csv";
      Result again = Launcher.pendant(folder, "run", "--record", name, "busy.script");
      byte[] record = Files.readAllBytes(folder.resolve(name));
      assertAll(
          () -> assertEquals(first.output(), again.output()),
          () -> assertArrayEquals(expected, record));
    }
  }

  @Test
  void aRecordingHasAllOfTheRunAndIsTheSameEachTime() throws IOException {
    Result first = Launcher.pendant(folder, "run", "--record", "0.rec", "busy.script");
    Result second = Launcher.pendant(folder, "run", "--record", "1.rec", "busy.script");

    assertEquals(0, first.exitCode(), first.errors());
    assertEquals(0, second.exitCode(), second.errors());
    assertArrayEquals(
        Files.readAllBytes(folder.resolve("0.rec")), Files.readAllBytes(folder.resolve("1.rec")));
    RecordingFile.Opened opened = RecordingFile.open(folder.resolve("0.rec"));
    assertTrue(opened.warning().isEmpty(), opened.warning().toString());
    Recording recording = opened.recording();
    assertEquals(0, recording.firstFrame());
    assertTrue(recording.lastFrame() > 500, recording.lastFrame() + " frames");
    assertEquals(first.output().strip(), recording.log(0, 1000).getLast().text().strip());
    assertEquals(
        Files.readString(folder.resolve("busy.script")),
        recording.programs().getFirst().source().text());
  }

  @Test
  void columnsOfVariablesFollowInEveryRow() throws IOException {
    Launcher.script(
        folder,
        "count.script",
        """
        def count():
          n = 0
          p = p[0, 0, 0, 0, 0, 0]
          while n < 3:
            n = n + 1
            p[2] = 0.5 * n
            sync()
          end
          late = True
          sync()
        end
        """);
    Result result =
        Launcher.pendant(
            folder,
            "run",
            "--record",
            "out.csv",
            "--column",
            "var:n",
            "--column",
            "var:p[2]",
            "--column=var:late",
            "count.script");

    assertEquals(0, result.exitCode(), result.errors());
    List<String> lines = Files.readAllLines(folder.resolve("out.csv"));
    assertTrue(lines.getFirst().endsWith(",line,var:n,var:p[2],var:late"), lines.getFirst());
    assertTrue(lines.get(1).endsWith(",1.0,0.5,"), lines.get(1));
    assertTrue(lines.get(3).endsWith(",3.0,1.5,"), lines.get(3));
    assertTrue(lines.get(4).endsWith(",3.0,1.5,1.0"), lines.get(4));
  }

  @Test
  void columnThatTheProgramDoesNotHaveIsRefused() {
    Result result =
        Launcher.pendant(
            folder, "run", "--record", "out.csv", "--column", "var:hom", "busy.script");

    assertEquals(2, result.exitCode());
    assertTrue(
        result.errors().contains("busy has no variable hom, did you mean home?"), result.errors());
  }

  @Test
  void columnWithoutARecordIsRefused() {
    Result result = Launcher.pendant(folder, "run", "--column", "var:home", "busy.script");

    assertEquals(2, result.exitCode());
    assertTrue(result.errors().contains("--column goes with --record"), result.errors());
  }

  /** Killed without a warning, at many moments: what was recorded until then can be read. */
  @Test
  void recordingOfAKilledProcessCanBeRead() throws IOException, InterruptedException {
    Launcher.script(
        folder,
        "endless.script",
        """
        def endless():
          textmsg("started")
          while True:
            movej([0.8, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=1)
            movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=1)
          end
        end
        """);
    Random random = new Random(12);
    for (int i = 0; i < KILLS; i++) {
      Path file = folder.resolve("killed" + i + ".rec");
      Process process =
          Launcher.start(folder, "run", "--record", file.toString(), "endless.script");
      long bytes = i == 0 ? 1 : 1 + random.nextInt(1 << random.nextInt(10, 21));
      try (WatchService changes = folder.getFileSystem().newWatchService()) {
        folder.register(changes, ENTRY_CREATE, ENTRY_MODIFY);
        while (process.isAlive() && (!Files.exists(file) || Files.size(file) < bytes)) {
          WatchKey key = changes.poll(1, TimeUnit.SECONDS);
          if (key != null) {
            key.pollEvents();
            key.reset();
          }
        }
      }
      process.destroyForcibly();
      process.waitFor();

      RecordingFile.Opened opened = RecordingFile.open(file);
      assertTrue(opened.warning().isPresent(), "seed 12, kill " + i);
      Recording recording = opened.recording();
      assertEquals(recording.lastFrame(), recording.atFrame(recording.lastFrame()).frame());
    }
  }
}
