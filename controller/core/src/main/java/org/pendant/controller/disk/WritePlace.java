package org.pendant.controller.disk;

import static org.pendant.controller.disk.DiskTexts.text;

import java.io.IOException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ThreadLocalRandom;

/**
 * Write location: where what is written under a name goes: links are followed, so that a link stays
 * and leads to the new file.
 *
 * @param path absolute
 * @param special whether it is a pipe, a device or an open file of a process, such as {@code
 *     /dev/stdout}, into which bytes go as they come; no file can take its place
 */
public record WritePlace(Path path, boolean special) {
  private static final int MAX_LINKS = 40;

  /** Names have at most 255 bytes in most file systems; a character takes up to 4. */
  private static final int MAX_CHARACTERS = 40;

  /** Folders whose entries stand for open files, also for regular ones. */
  private static final List<Path> OPEN_FILES = List.of(Path.of("/proc"), Path.of("/dev/fd"));

  /**
   * The place that a name leads to, which need not exist.
   *
   * @throws IOException if its links form a loop or cannot be read
   */
  public static WritePlace of(Path name) throws IOException {
    Path path = name.toAbsolutePath();
    for (int links = 0; ; links++) {
      if (OPEN_FILES.stream().anyMatch(path::startsWith) && Files.exists(path)) {
        return new WritePlace(path, true);
      }
      if (!Files.isSymbolicLink(path)) {
        break;
      }
      if (links == MAX_LINKS) {
        throw new FileSystemLoopException(name.toString());
      }
      path = path.resolveSibling(Files.readSymbolicLink(path));
    }
    if (!Files.exists(path)) {
      return new WritePlace(path, false);
    }
    return new WritePlace(
        path.toRealPath(), !Files.isRegularFile(path) && !Files.isDirectory(path));
  }

  /** The folder that it is in. */
  public Path folder() {
    Path folder = path.getParent();
    return folder == null ? path : folder;
  }

  /** A hidden name in the same folder, another one each time. */
  Path beside() {
    String name = path.getFileName().toString();
    int characters = Math.min(MAX_CHARACTERS, name.codePointCount(0, name.length()));
    return path.resolveSibling(
        "."
            + name.substring(0, name.offsetByCodePoints(0, characters))
            + "."
            + Integer.toHexString(ThreadLocalRandom.current().nextInt())
            + ".new");
  }

  /** Whether there is a file that writing would replace. */
  public boolean occupied() {
    return !special && Files.exists(path);
  }

  /**
   * Refuses what can never be written.
   *
   * @throws IOException says why, without the name
   */
  public void check() throws IOException {
    if (Files.isDirectory(path)) {
      throw new IOException(text("folder"));
    }
    if (Files.exists(path) && !Files.isWritable(path)) {
      throw new IOException(text("mayNotBeWritten"));
    }
    if (!special && Files.exists(folder()) && !Files.isDirectory(folder())) {
      throw new IOException(text("noFolder", folder()));
    }
    if (!special && Files.exists(folder()) && !Files.isWritable(folder())) {
      throw new IOException(text("folderMayNotBeWritten"));
    }
  }
}
