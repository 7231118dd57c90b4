package org.pendant.gui.session;

import java.io.IOException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;

/** Replaces files as a whole. */
public final class AtomicFile {
  private AtomicFile() {}

  /**
   * Writes a file so that it is either the old one or the new one, whatever happens meanwhile.
   * Links are followed; folders are made.
   *
   * @throws IOException if it cannot be written; its message is the file and the reason, and the
   *     old one is still there then
   */
  public static void write(Path path, byte[] bytes) throws IOException {
    try {
      replace(path, bytes);
    } catch (IOException e) {
      throw FileTrouble.of(path, e);
    }
  }

  private static void replace(Path path, byte[] bytes) throws IOException {
    Path target = Files.exists(path) ? path.toRealPath() : path.toAbsolutePath();
    if (Files.exists(target) && !Files.isWritable(target)) {
      throw new IOException("it may not be written");
    }
    if (Files.isDirectory(target)) {
      throw new IOException("it is a folder");
    }
    Files.createDirectories(target.getParent());
    if (!Files.isWritable(target.getParent())) {
      throw new IOException("nothing may be written in its folder");
    }
    Path beside = Files.createTempFile(target.getParent(), "." + target.getFileName(), ".new");
    try {
      Files.write(beside, bytes);
      if (Files.exists(target)) {
        keepPermissions(target, beside);
      }
      move(beside, target);
    } finally {
      Files.deleteIfExists(beside);
    }
  }

  private static void keepPermissions(Path from, Path to) throws IOException {
    try {
      Files.setPosixFilePermissions(to, Files.getPosixFilePermissions(from));
    } catch (UnsupportedOperationException e) {
      // This file system has none.
    }
  }

  private static void move(Path from, Path to) throws IOException {
    try {
      Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
    }
  }
}
