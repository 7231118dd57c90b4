package org.pendant.sweep.remote;

import static org.pendant.sweep.remote.RemoteTexts.text;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.sweep.folder.SweepFolder;

/** Job files: those that go to workers, with a limit on how many and how large. Mutable. */
final class JobFiles {
  /** A plan with more files beside it belongs into a folder of its own. */
  static final int MAX_FILES = 2_000;

  /** Bytes of all files. */
  static final long MAX_BYTES = 256L << 20;

  private final SortedSet<Path> files = new TreeSet<>();
  private long bytes;

  /** All that were added. */
  SortedSet<Path> all() {
    return files;
  }

  /** Adds a file. */
  void add(Path file) throws IOException {
    if (!files.add(file)) {
      return;
    }
    bytes += Files.size(file);
    if (files.size() > MAX_FILES || bytes > MAX_BYTES) {
      throw new IOException(text("tooManyFiles", file.getParent(), MAX_FILES, MAX_BYTES >> 20));
    }
  }

  /** Adds all files below a folder that are not hidden, and no results. */
  void addAllIn(Path top) throws IOException {
    Files.walkFileTree(
        top,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            boolean skipped = !folder.equals(top) && (hidden(folder) || SweepFolder.begun(folder));
            return skipped ? FileVisitResult.SKIP_SUBTREE : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes)
              throws IOException {
            if (attributes.isRegularFile() && !hidden(file)) {
              add(file);
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException trouble)
              throws IOException {
            throw FileTrouble.of(file, trouble);
          }
        });
  }

  private static boolean hidden(Path file) {
    return file.getFileName().toString().startsWith(".");
  }
}
