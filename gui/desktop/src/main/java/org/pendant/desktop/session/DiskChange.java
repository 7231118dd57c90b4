package org.pendant.desktop.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Optional;

/**
 * Disk change: notices that another program has changed a file. It reads, so not in the dispatch
 * thread; one thread uses it.
 */
public final class DiskChange {
  private Optional<Stamp> seen = Optional.empty();
  private boolean wasGone;

  private record Stamp(Path path, long modifiedMs, long bytes) {}

  /** Whether the file is there no more, where it was at the last look. */
  public boolean gone(SavedProgram known) {
    boolean gone = seen.isPresent() && !Files.exists(known.path());
    if (gone) {
      seen = Optional.empty();
      wasGone = true;
    }
    return gone;
  }

  /**
   * The file as it is now, if it has changed since the last look and its text is another one than
   * {@code known}, or if it was gone.
   *
   * @throws IOException if it is there but cannot be read
   */
  public Optional<SavedProgram> look(SavedProgram known) throws IOException {
    Path path = known.path();
    if (!Files.exists(path)) {
      return Optional.empty();
    }
    BasicFileAttributes attributes = Files.readAttributes(path, BasicFileAttributes.class);
    Optional<Stamp> now =
        Optional.of(new Stamp(path, attributes.lastModifiedTime().toMillis(), attributes.size()));
    if (now.equals(seen)) {
      return Optional.empty();
    }
    seen = now;
    SavedProgram read = SavedProgram.read(path);
    boolean back = wasGone;
    wasGone = false;
    return !back && read.text().equals(known.text()) ? Optional.empty() : Optional.of(read);
  }
}
