package org.pendant.gui.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;

/** Reads the files that a command line names. */
final class SourceFiles {
  /**
   * Far above any real program; a larger file is a mistake, and reading it would only hide that.
   */
  private static final int LARGEST_BYTES = 32 << 20;

  private SourceFiles() {}

  /**
   * All of a file.
   *
   * @throws UsageException when it cannot be read
   */
  static byte[] bytes(String name) throws UsageException {
    try {
      Path path = Path.of(name);
      if (Files.isDirectory(path)) {
        throw new UsageException(name + " is a directory, expected a file");
      }
      // the size that a device or a pipe states says nothing, so the reading itself is bounded
      try (InputStream in = Files.newInputStream(path)) {
        byte[] bytes = in.readNBytes(LARGEST_BYTES + 1);
        if (bytes.length > LARGEST_BYTES) {
          throw new UsageException(
              name + " has more than " + LARGEST_BYTES + " bytes, no program is that large");
        }
        return bytes;
      }
    } catch (NoSuchFileException e) {
      throw new UsageException(name + ": no such file");
    } catch (AccessDeniedException e) {
      throw new UsageException(name + ": no permission to read it");
    } catch (InvalidPathException e) {
      throw new UsageException(name + ": not a file name, " + e.getReason());
    } catch (IOException e) {
      throw new UsageException(name + ": cannot be read, " + e.getMessage());
    }
  }
}
