package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.models.arm.ArmDescription;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.installation.file.InstallationTrouble;
import org.pendant.project.installation.file.LoadedInstallation;

/** Option {@code --installation FILE}: how the robot is set up. */
final class InstallationOption {
  static final Option OPTION =
      Option.input("--installation", "FILE")
          .documented(
              "cell.pinst",
              "how the robot is set up: TCPs, payloads, mounting, signals, safety, see"
                  + " [installations.md](installations.md). Default for a program tree: the file"
                  + " that it names, beside it");

  private InstallationOption() {}

  /** The installation that the command line names; empty if it names none. */
  static Optional<Installation> of(Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(OPTION);
    return name.isPresent()
        ? Optional.of(read(name.get(), arguments.files()).installation())
        : Optional.empty();
  }

  /**
   * As {@link #of}, but what it says of other files is as it stands there, as seen from the
   * installation's own file.
   */
  static Optional<Installation> asWritten(Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(OPTION);
    return name.isPresent()
        ? Optional.of(load(name.get(), arguments.files()).installation())
        : Optional.empty();
  }

  /** Says what of the installation that the command line names was not understood. */
  static void tell(Arguments arguments, Console console) throws UsageException {
    Optional<String> name = arguments.value(OPTION);
    if (name.isPresent()) {
      notes(name.get(), read(name.get(), arguments.files())).forEach(console::complainFromEnglish);
    }
  }

  private static List<String> notes(String name, LoadedInstallation read) {
    return read.remarks().stream()
        .map(each -> text("noteIn", name, CommandLanguage.shown(each)))
        .toList();
  }

  /** Reads an installation, with what it says of other files as seen from here. */
  static LoadedInstallation read(String name, SourceFiles files) throws UsageException {
    LoadedInstallation read = load(name, files);
    return new LoadedInstallation(placed(name, read.installation()), read.remarks());
  }

  /** Reads an installation from a file, and the values of its variables from the one beside it. */
  private static LoadedInstallation load(String name, SourceFiles files) throws UsageException {
    try {
      Optional<String> variables =
          InstallationFile.variablesOf(name).filter(file -> Files.isRegularFile(Path.of(file)));
      Optional<byte[]> values =
          variables.isPresent()
              ? Optional.of(bytes(files.path("theFileOfVariables", variables.get())))
              : Optional.empty();
      return InstallationFile.read(name, bytes(files.path("theInstallation", name)), values);
    } catch (InstallationTrouble e) {
      throw UsageException.fromEnglish(e);
    } catch (InvalidPathException e) {
      throw new UsageException(text("notAFileName", name, e.getReason()));
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  /** With the calibration where it is as seen from here, rather than from the installation. */
  private static Installation placed(String name, Installation installation) {
    String calibration = installation.calibration();
    return calibration.isEmpty()
        ? installation
        : installation.with(
            parts -> parts.calibration = Path.of(name).resolveSibling(calibration).toString());
  }

  /**
   * The installation that a program names, if its file stands beside the program.
   *
   * @param program file name of the program
   * @param installation name of the installation, with an ending or without; empty for none
   * @param notes takes what of it was not understood
   */
  static Optional<Installation> beside(
      String program, String installation, SourceFiles files, List<String> notes)
      throws UsageException {
    if (installation.isEmpty()) {
      return Optional.empty();
    }
    for (String each : InstallationFile.namesOf(installation)) {
      try {
        Path file = Path.of(program).resolveSibling(each);
        if (Files.isRegularFile(file)) {
          LoadedInstallation read = read(file.toString(), files);
          notes.addAll(notes(file.toString(), read));
          return Optional.of(read.installation());
        }
      } catch (InvalidPathException e) {
        throw new UsageException(text("installationNotAFileName", program, installation));
      }
    }
    return Optional.empty();
  }

  private static byte[] bytes(Path path) throws IOException, UsageException {
    try (InputStream in = Files.newInputStream(path)) {
      byte[] bytes = in.readNBytes(InstallationFile.MAX_BYTES + 1);
      if (bytes.length > InstallationFile.MAX_BYTES) {
        throw new UsageException(text("tooManyBytes", path, InstallationFile.MAX_BYTES));
      }
      return bytes;
    }
  }

  /**
   * {@code options} set up as an installation says.
   *
   * @throws UsageException if the arm of the options cannot be set up so
   */
  static ControllerOptions in(ControllerOptions options, Installation installation)
      throws UsageException {
    refuseUnlessFor(installation, options.arm());
    return options.withInstallation(installation);
  }

  /** Refuses an installation with which an arm cannot be set up. */
  static void refuseUnlessFor(Installation installation, ArmDescription arm) throws UsageException {
    Optional<InstallationProblem> refusal = InstallationCheck.refusal(installation, arm);
    if (refusal.isPresent()) {
      throw new UsageException(text("installationUnusable", refusal.get()));
    }
  }
}
