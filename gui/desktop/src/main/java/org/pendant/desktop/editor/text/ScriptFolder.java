package org.pendant.desktop.editor.text;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.FileVisitor;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.Collections;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;

/** Script folder: the scripts in a folder and the folders in it. Slow: for a worker thread. */
public final class ScriptFolder {
  private static final int DEEPEST = 12;

  /** A folder with more files than this is no folder of programs. */
  private static final int MAX_SEEN = 200_000;

  private ScriptFolder() {}

  /**
   * Lists scripts in the order of their names; hidden folders and what cannot be read are left out.
   *
   * @param most how many at most
   * @param cancelled asked before each file; the list ends there
   * @throws IOException if the folder itself cannot be read
   */
  public static List<Path> list(Path folder, int most, BooleanSupplier cancelled)
      throws IOException {
    List<Path> scripts = new ArrayList<>();
    try (var entries = Files.newDirectoryStream(folder)) {
      var _ = entries.iterator().hasNext();
    }
    FileVisitor<Path> visitor =
        new SimpleFileVisitor<>() {
          private int seen;

          @Override
          public FileVisitResult preVisitDirectory(Path inner, BasicFileAttributes attributes) {
            boolean hidden = inner.getNameCount() > 0 && name(inner).startsWith(".");
            return hidden && !inner.equals(folder)
                ? FileVisitResult.SKIP_SUBTREE
                : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            if (attributes.isRegularFile()
                && name(file).toLowerCase(Locale.ROOT).endsWith(".script")) {
              scripts.add(file);
            }
            boolean enough =
                scripts.size() >= most || ++seen >= MAX_SEEN || cancelled.getAsBoolean();
            return enough ? FileVisitResult.TERMINATE : FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path file, IOException why) {
            return FileVisitResult.CONTINUE;
          }
        };
    Files.walkFileTree(
        folder, EnumSet.noneOf(java.nio.file.FileVisitOption.class), DEEPEST, visitor);
    Collections.sort(scripts);
    return scripts;
  }

  private static String name(Path path) {
    return String.valueOf(path.getFileName());
  }
}
