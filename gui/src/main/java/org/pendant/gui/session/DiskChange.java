package org.pendant.gui.session;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Optional;

/**
 * Notices that somebody else has changed a file. It reads, so not in the dispatch thread; one
 * thread uses it.
 */
public final class DiskChange {
  private Optional<Stamp> seen = Optional.empty();

  private record Stamp(Path path, long modifiedMs, long bytes) {}

  /**
   * The file as it is now, if it has changed since the last look and its text is another one than
   * {@code known}.
   *
   * @throws IOException if it is there but cannot be read
   */
  public Optional<ProgramFile> look(ProgramFile known) throws IOException {
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
    ProgramFile read = ProgramFile.read(path);
    return read.text().equals(known.text()) ? Optional.empty() : Optional.of(read);
  }
}
