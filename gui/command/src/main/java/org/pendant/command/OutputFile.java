package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.disk.WritePlace;

/**
 * Output file that a command line wants written. It is looked at before anything runs: no user
 * wants to wait for a refusal.
 *
 * @param name as people call it, with the option if there is one, for messages
 * @param path where it is
 * @param force whether one that is there may be replaced
 */
record OutputFile(String name, Path path, boolean force) {
  static final Option FORCE =
      Option.flag("--force")
          .documented(
              "replace the file of `--record`, `--profile`, `--trace`, `--out`, `--junit`, `--tap`"
                  + " or `TO`, if there is one already");

  /**
   * The file that an option names.
   *
   * @param arguments by which everything has been read that the command reads
   * @throws UsageException when it is one of the files that are read, is there and may not be
   *     replaced, or cannot be written
   */
  static Optional<OutputFile> of(Option option, Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(option);
    return name.isPresent()
        ? Optional.of(at(option.name() + " " + name.get(), name.get(), arguments))
        : Optional.empty();
  }

  /** As the other one, for one of the values of an option that may be given several times. */
  static OutputFile of(Option option, String name, Arguments arguments) throws UsageException {
    return at(option.name() + " " + name, name, arguments);
  }

  /** As {@link #of}, for one that may be replaced without {@link #FORCE}. */
  static OutputFile replacing(Option option, String name, Arguments arguments)
      throws UsageException {
    return at(option.name() + " " + name, name, true, arguments);
  }

  /** As {@link #of}, for one that is named without an option. */
  static OutputFile at(String name, Arguments arguments) throws UsageException {
    return at(name, name, arguments);
  }

  private static OutputFile at(String shown, String name, Arguments arguments)
      throws UsageException {
    return at(shown, name, arguments.has(FORCE), arguments);
  }

  private static OutputFile at(String shown, String name, boolean force, Arguments arguments)
      throws UsageException {
    try {
      OutputFile file = new OutputFile(shown, Path.of(name).toAbsolutePath(), force);
      file.check(name, arguments.files());
      return file;
    } catch (InvalidPathException e) {
      throw new UsageException(text("notAFileName", shown, e.getReason()));
    } catch (IOException e) {
      throw new UsageException(text("cannotBeWritten", shown, FileTrouble.reason(e)));
    }
  }

  private void check(String plainName, SourceFiles read) throws IOException, UsageException {
    WritePlace place = WritePlace.of(path);
    if (name.isBlank() || plainName.isBlank()) {
      throw new UsageException(text("fileNameMissing", name));
    }
    if (Files.isDirectory(place.path())) {
      throw new UsageException(text("directoryNotFile", name));
    }
    Optional<SourceFiles.SourceFile> source =
        place.occupied() ? read.same(place.path()) : Optional.empty();
    if (source.isPresent()) {
      String same = source.get().name().equals(plainName) ? "" : " " + source.get().name();
      throw new UsageException(
          text(
              force ? "neverOverwrittenByForce" : "neverOverwritten",
              name,
              text(source.get().role()) + same));
    }
    if (place.occupied() && !force) {
      throw new UsageException(text("existsAlready", name));
    }
    place.check();
    if (!place.special() && !Files.isDirectory(place.folder())) {
      throw new UsageException(text("noFolder", name, place.folder()));
    }
  }

  /** Whether there is one that is going to be replaced. */
  boolean replaces() throws IOException {
    return force && WritePlace.of(path).occupied();
  }

  /**
   * Opens it for what comes over time; what has come stays when the process ends.
   *
   * @throws UsageException if it cannot be opened, or has come into being and may not be replaced
   */
  OutputStream stream() throws UsageException {
    try {
      return force || WritePlace.of(path).special()
          ? Files.newOutputStream(path)
          : Files.newOutputStream(path, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    } catch (IOException e) {
      throw new UsageException(text("cannotBeWritten", name, FileTrouble.reason(e)));
    }
  }

  /** Writes it as a whole, or leaves everything as it was. */
  void write(AtomicFile.Content content) throws UsageException {
    try {
      if (force || WritePlace.of(path).special()) {
        AtomicFile.write(path, content);
      } else {
        AtomicFile.create(path, content);
      }
    } catch (IOException e) {
      throw new UsageException(text("cannotBeWritten", name, FileTrouble.reason(e)));
    }
  }
}
