package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.recording.RecordingException;

/**
 * Source files: reads the files that a command line names, and remembers them: nothing is ever
 * written onto what a command reads.
 */
final class SourceFiles {
  /**
   * Far above any real program; a larger file is a mistake, and reading it would only hide that.
   */
  private static final int MAX_BYTES = 32 << 20;

  private static final String TOOLPATH = ".nc";

  private final List<SourceFile> read = new ArrayList<>();

  /**
   * A file that the command reads.
   *
   * @param role what it is to the command, the key of a text such as {@code theScene}
   * @param name as people call it
   */
  record SourceFile(String role, String name, Path path) {}

  /**
   * The path of a file that is going to be read.
   *
   * @param role what it is to the command, the key of a text such as {@code theScene}
   * @throws UsageException when it is no name of a file
   */
  Path path(String role, String name) throws UsageException {
    try {
      Path path = Path.of(name);
      read.add(new SourceFile(role, name, path));
      return path;
    } catch (InvalidPathException e) {
      throw new UsageException(text("notAFileName", name, e.getReason()));
    }
  }

  /**
   * All of a file.
   *
   * @param role what it is to the command, the key of a text such as {@code theProgram}
   * @throws UsageException when it cannot be read
   */
  byte[] bytes(String role, String name) throws UsageException {
    Path path = path(role, name);
    try {
      if (Files.isDirectory(path)) {
        throw new UsageException(text("directoryNotFile", name));
      }
      // the size that a device or a pipe states says nothing, so the reading itself is bounded
      try (InputStream in = Files.newInputStream(path)) {
        byte[] bytes = in.readNBytes(MAX_BYTES + 1);
        if (bytes.length > MAX_BYTES) {
          throw new UsageException(text("programTooLarge", name, MAX_BYTES));
        }
        return bytes;
      }
    } catch (IOException e) {
      throw unreadable(name, e);
    }
  }

  /** What is said of a file that cannot be read; of all files in the same words. */
  static UsageException unreadable(String name, IOException e) {
    return switch (e) {
      // says itself which file it is
      case RecordingException damaged -> UsageException.fromEnglish(damaged);
      default -> new UsageException(name + ": " + CommandLanguage.shown(FileTrouble.reason(e)));
    };
  }

  /**
   * The file that was read and is the one at {@code path}, by whatever name: through {@code ..},
   * links of both kinds, or in other letters where the file system does not tell them apart.
   */
  Optional<SourceFile> same(Path path) {
    return read.stream()
        .filter(each -> same(each.path(), path))
        .findFirst()
        .or(() -> toolpath(path));
  }

  /** Which toolpaths a program reads shows only when it runs: it may read all that are with it. */
  private Optional<SourceFile> toolpath(Path path) {
    String name = path.toString();
    boolean may =
        name.toLowerCase(Locale.ROOT).endsWith(TOOLPATH)
            && read.stream()
                .filter(each -> each.role().equals(RunnableFile.PROGRAM))
                .anyMatch(each -> isWith(each.path(), path));
    return may ? Optional.of(new SourceFile("aToolpath", name, path)) : Optional.empty();
  }

  private static boolean isWith(Path program, Path path) {
    try {
      return path.toRealPath().startsWith(program.toRealPath().getParent());
    } catch (IOException e) {
      return false;
    }
  }

  private static boolean same(Path one, Path other) {
    try {
      return Files.isSameFile(one, other);
    } catch (IOException e) {
      // A file that is not there, or cannot be looked at, cannot be overwritten either.
      return false;
    }
  }
}
