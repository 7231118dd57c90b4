package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.pendant.command.service.StateFolder;
import org.pendant.controller.disk.FileTrouble;

/** Looks whether there is room for what Pendant writes, and the right to write it. */
public final class DiskInspection implements Inspection {
  /** A recording of an hour has less, bytes. */
  private static final long MIN_FREE = 1L << 30;

  private static final long MB = 1_000_000;

  @Override
  public List<Finding> findings() {
    return List.of(
        folder(text("logs"), StateFolder.of(System.getenv())),
        folder(text("temporary"), Path.of(System.getProperty("java.io.tmpdir"))));
  }

  /**
   * Looks at a folder, which may not be there yet.
   *
   * @param subject what it is for
   */
  public static Finding folder(FindingText subject, Path folder) {
    Path there = folder.toAbsolutePath();
    while (!Files.exists(there) && there.getParent() != null) {
      there = there.getParent();
    }
    if (!Files.isDirectory(there) || !Files.isWritable(there)) {
      return Finding.problem(
          subject,
          text(Files.isDirectory(there) ? "readOnly" : "noFolder", folder, there),
          text("getTheRightToWrite"));
    }
    try {
      long free = Files.getFileStore(there).getUsableSpace();
      FindingText found = text("mbFree", folder, FindingText.count(free / MB));
      return free < MIN_FREE
          ? Finding.problem(subject, found, text("recordingsMayNotFit"))
          : Finding.ok(subject, found);
    } catch (IOException e) {
      return Finding.note(
          subject,
          text("folderAndReason", folder, FindingText.message(FileTrouble.reason(e))),
          text("freeCannotBeTold"));
    }
  }
}
