package org.pendant.desktop.session;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.pendant.controller.disk.AtomicFile;

/**
 * Recovery folder: texts that are not saved yet, kept against a crash: a file each in a folder of
 * the user. It reads and writes, so not in the dispatch thread.
 */
public final class RecoveryFolder {
  private static final String HEADING = "pendant recovery 2";
  private static final String ENDING = ".recovery";

  private final Path folder;
  private final Owner self;
  private final Predicate<Owner> alive;

  /**
   * A text that was left behind.
   *
   * @param kept where it is kept
   * @param file where it was to be saved; empty if it had no file yet
   * @param name of the program
   */
  public record LeftBehind(Path kept, Optional<Path> file, String name, String text) {}

  /** The folder for this process. */
  public RecoveryFolder(Path folder) {
    this(folder, Owner.self(), Owner::alive);
  }

  RecoveryFolder(Path folder, Owner self, Predicate<Owner> alive) {
    this.folder = folder;
    this.self = self;
    this.alive = alive;
  }

  /** Where the text of a program is kept: each process has its own. */
  private Path place(int number) {
    return folder.resolve(self.process() + "-" + self.startedMs() + "-" + number + ENDING);
  }

  /**
   * Keeps a text until it is forgotten or kept again.
   *
   * @param number of the program in this process; two may have the same name
   * @param file where it is to be saved; empty if it has no file yet
   */
  public void keep(int number, Optional<Path> file, String name, String text) throws IOException {
    String whole =
        String.join(
            "\n",
            HEADING,
            self.toString(),
            file.map(path -> path.toAbsolutePath().toString()).orElse(""),
            name,
            text);
    AtomicFile.writePrivate(place(number), whole.getBytes(StandardCharsets.UTF_8));
  }

  /** The text is saved, or not wanted any more. */
  public void forget(int number) throws IOException {
    Files.deleteIfExists(place(number));
  }

  /** As {@link #forget(int)}, for one that was left behind. */
  public void forget(LeftBehind text) throws IOException {
    Files.deleteIfExists(text.kept());
  }

  /** The texts of processes that are no more; files that cannot be read are left out. */
  public List<LeftBehind> leftBehind() throws IOException {
    List<LeftBehind> found = new ArrayList<>();
    try (Stream<Path> files = Files.list(folder)) {
      for (Path each : files.filter(path -> path.toString().endsWith(ENDING)).sorted().toList()) {
        read(each).ifPresent(found::add);
      }
    } catch (NoSuchFileException e) {
      // Nothing was ever kept.
      return List.of();
    }
    return found;
  }

  private Optional<LeftBehind> read(Path kept) throws IOException {
    String[] parts = new String(Files.readAllBytes(kept), StandardCharsets.UTF_8).split("\n", 5);
    if (parts.length < 5 || !parts[0].equals(HEADING)) {
      return Optional.empty();
    }
    if (Owner.parse(parts[1]).filter(alive.negate()).isEmpty()) {
      return Optional.empty();
    }
    try {
      Optional<Path> file = parts[2].isEmpty() ? Optional.empty() : Optional.of(Path.of(parts[2]));
      return Optional.of(new LeftBehind(kept, file, parts[3], parts[4]));
    } catch (InvalidPathException e) {
      // The text is worth more than where it was.
      return Optional.of(new LeftBehind(kept, Optional.empty(), parts[3], parts[4]));
    }
  }
}
