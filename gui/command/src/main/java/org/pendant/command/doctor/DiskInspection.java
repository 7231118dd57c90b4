package org.pendant.command.doctor;

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
        folder("Logs", StateFolder.of(System.getenv())),
        folder("Temporary", Path.of(System.getProperty("java.io.tmpdir"))));
  }

  /**
   * Looks at a folder, which may not be there yet.
   *
   * @param subject what it is for
   */
  public static Finding folder(String subject, Path folder) {
    Path there = folder.toAbsolutePath();
    while (!Files.exists(there) && there.getParent() != null) {
      there = there.getParent();
    }
    if (!Files.isDirectory(there) || !Files.isWritable(there)) {
      return Finding.problem(
          subject,
          folder + ": " + there + (Files.isDirectory(there) ? " is read-only" : " is no folder"),
          "give yourself the right to write there, or move it away");
    }
    try {
      long free = Files.getFileStore(there).getUsableSpace();
      String found = "%s, %,d MB free".formatted(folder, free / MB);
      return free < MIN_FREE
          ? Finding.problem(subject, found, "recordings and logs may not fit: free some of it")
          : Finding.ok(subject, found);
    } catch (IOException e) {
      return Finding.note(
          subject, folder + ", " + FileTrouble.reason(e), "how much is free there cannot be told");
    }
  }
}
