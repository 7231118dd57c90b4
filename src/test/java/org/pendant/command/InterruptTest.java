package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Ctrl-C and its relatives, in the middle of a move. */
@Tag("slow")
final class InterruptTest {
  /** The columns of the target joint speeds in the record. */
  private static final int FIRST_TARGET_SPEED = 7;

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({"INT, 130, 1", "TERM, 143, 1", "INT, 130, max"})
  void signalBringsTheArmToRestAndKeepsTheRecord(String signal, int exitCode, String speed)
      throws IOException, InterruptedException {
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
    Process process =
        Launcher.start(folder, "run", "--speed", speed, "--record", "out.csv", "endless.script");

    try (BufferedReader output = process.inputReader(StandardCharsets.UTF_8)) {
      assertEquals("started", output.readLine());
      Process kill = new ProcessBuilder("kill", "-" + signal, Long.toString(process.pid())).start();
      assertEquals(0, kill.waitFor());
      assertEquals(exitCode, Launcher.await(process));
    }

    List<String> errors = process.errorReader(StandardCharsets.UTF_8).lines().toList();
    assertTrue(errors.stream().noneMatch(line -> line.startsWith("\tat ")), errors.toString());
    String record = Files.readString(folder.resolve("out.csv"));
    assertTrue(record.endsWith("\n"), "the record ends in the middle of a row");
    String[] last =
        record.substring(record.lastIndexOf('\n', record.length() - 2) + 1).split(",", -1);
    for (int joint = 0; joint < 6; joint++) {
      assertEquals(0, Double.parseDouble(last[FIRST_TARGET_SPEED + joint]), 1e-9);
    }
  }
}
