package org.pendant.command.doctor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class CrashLogsTest {
  private static final String OURS = "Command Line: -XX:+UseSerialGC -jar lib/pendant.jar run a\n";

  @TempDir private Path folder;

  private Path log(String name, String time, String text) throws IOException {
    Path file = Files.writeString(folder.resolve(name), text);
    return Files.setLastModifiedTime(file, FileTime.from(Instant.parse(time)));
  }

  private static Finding finding(Path... folders) {
    return new CrashInspection(List.of(folders)).findings().getFirst();
  }

  @Test
  void withoutAnyAllIsWell() throws IOException {
    log("replay_pid7.log", "2026-11-02T10:00:00Z", OURS);

    assertEquals(Finding.Level.OK, finding(folder, folder.resolve("missing")).level());
  }

  @Test
  void theLastOneIsNamedWithItsDay() throws IOException {
    log("hs_err_pid7.log", "2026-11-02T10:00:00Z", OURS);
    Path last = log("hs_err_pid5.log", "2026-11-03T10:00:00Z", OURS);

    assertEquals(Finding.Level.NOTE, finding(folder).level());
    assertEquals("the last on 2026-11-03: " + last, finding(folder).found().english());
  }

  @Test
  void ofManyTheNewestThreeAreTaken() throws IOException {
    for (int day = 1; day <= 5; day++) {
      log("hs_err_pid" + day + ".log", "2026-11-0" + day + "T10:00:00Z", OURS);
    }

    assertEquals(
        List.of("hs_err_pid5.log", "hs_err_pid4.log", "hs_err_pid3.log"),
        CrashLogs.newest(List.of(folder)).stream().map(f -> f.getFileName().toString()).toList());
  }

  @Test
  void crashesOfOtherProgramsAreNotOurs() throws IOException {
    log("hs_err_pid7.log", "2026-11-02T10:00:00Z", "Command Line: -jar my.jar secret\n");

    assertEquals(Finding.Level.OK, finding(folder).level());
  }

  @Test
  void theCommandLineOfAnotherProgramIsLeftOut() throws IOException {
    Path log = log("hs_err_pid1.log", "2026-11-02T10:00:00Z", "Command Line: -jar my.jar secret\n");

    assertEquals("Command Line: (left out)\n", CrashLogs.excerpt(log));
  }

  @Test
  void ofAFileThatNeverEndsTheBeginningIsRead() throws IOException {
    Path log =
        log("hs_err_pid1.log", "2026-11-02T10:00:00Z", ("x".repeat(5_000) + "\n").repeat(900));

    assertTrue(CrashLogs.excerpt(log).length() < 500_000);
  }
}
