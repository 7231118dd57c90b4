package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneOffset;
import java.util.List;
import org.pendant.controller.disk.FileTrouble;

/** Looks whether a JVM has crashed under Pendant. */
final class CrashInspection implements Inspection {
  private static final FindingText SUBJECT = text("crashes");

  private final List<Path> folders;

  /**
   * Looks into {@code folders}.
   *
   * @param folders where logs of crashes are; some may be missing
   */
  CrashInspection(List<Path> folders) {
    this.folders = List.copyOf(folders);
  }

  @Override
  public List<Finding> findings() {
    try {
      List<Path> logs = CrashLogs.newest(folders);
      return List.of(
          logs.isEmpty() ? Finding.ok(SUBJECT, text("noCrashes")) : last(logs.getFirst()));
    } catch (IOException e) {
      return List.of(
          Finding.note(
              SUBJECT, FindingText.message(FileTrouble.reason(e)), text("crashesCannotBeTold")));
    }
  }

  private static Finding last(Path log) throws IOException {
    return Finding.note(
        SUBJECT,
        text(
            "lastCrash",
            Files.getLastModifiedTime(log).toInstant().atOffset(ZoneOffset.UTC).toLocalDate(),
            log),
        text("reportTheCrash"));
  }
}
