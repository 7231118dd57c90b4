package org.pendant.project.installation.file;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.installation.text.ReadInstallation;
import org.pendant.project.installation.urp.ImportedInstallation;
import org.pendant.project.installation.urp.UrInstallations;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.text.TextProblem;

/** Installation file: reads installations by the endings of their names. */
public final class InstallationFile {
  /** Far above any real one. */
  public static final int MAX_BYTES = 32 << 20;

  /** Endings of such files, in the order in which they are looked for. */
  public static final List<String> ENDINGS =
      List.of(InstallationText.ENDING, UrInstallations.ENDING);

  private InstallationFile() {}

  /** Whether a file of this name may be an installation. */
  public static boolean hasEnding(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return ENDINGS.stream().anyMatch(lower::endsWith);
  }

  /**
   * The names that the file of an installation may have which a program calls {@code name}, with an
   * ending or without.
   */
  public static List<String> namesOf(String name) {
    return hasEnding(name) ? List.of(name) : ENDINGS.stream().map(ending -> name + ending).toList();
  }

  /**
   * The name of the file beside it that has the values of its variables; empty for our own form.
   */
  public static Optional<String> variablesOf(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(UrInstallations.ENDING)
        ? Optional.of(
            name.substring(0, name.length() - UrInstallations.ENDING.length())
                + UrInstallations.VARIABLES_ENDING)
        : Optional.empty();
  }

  /**
   * Reads one.
   *
   * @param name of the file, for its ending and for messages
   * @param variables bytes of the file of {@link #variablesOf}, if it is there
   * @throws InstallationTrouble for the first thing that is wrong
   */
  public static LoadedInstallation read(String name, byte[] bytes, Optional<byte[]> variables)
      throws InstallationTrouble {
    if (!hasEnding(name)) {
      throw new InstallationTrouble(
          InstallationFileTexts.text("otherEnding", name, String.join(" or ", ENDINGS)));
    }
    Optional<String> variablesName = variablesOf(name);
    return variablesName.isPresent()
        ? imported(name, bytes, variablesName.get(), variables)
        : new LoadedInstallation(text(name, bytes), List.of());
  }

  private static LoadedInstallation imported(
      String name, byte[] bytes, String variablesName, Optional<byte[]> variables)
      throws InstallationTrouble {
    ImportedInstallation read;
    try {
      read = UrInstallations.read(bytes);
    } catch (UnreadableFile e) {
      throw wrong(name, e);
    }
    Installation installation =
        read.calibrated()
            ? read.installation().with(parts -> parts.calibration = lastPart(name))
            : read.installation();
    if (variables.isEmpty()) {
      return new LoadedInstallation(installation, read.remarks());
    }
    try {
      List<InstallationVariable> values = UrInstallations.variables(variables.get());
      return new LoadedInstallation(installation.withVariables(values), read.remarks());
    } catch (UnreadableFile e) {
      throw wrong(variablesName, e);
    }
  }

  /** The name of a file in its folder. */
  private static String lastPart(String name) {
    return Path.of(name).getFileName().toString();
  }

  private static InstallationTrouble wrong(String name, UnreadableFile why) {
    String place = why.line() == 0 ? "" : ":" + why.line() + ":" + why.column();
    return new InstallationTrouble(name + place + ": " + why.getMessage());
  }

  private static Installation text(String name, byte[] bytes) throws InstallationTrouble {
    String text;
    try {
      text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(bytes)).toString();
    } catch (CharacterCodingException e) {
      throw new InstallationTrouble(InstallationFileTexts.text("noText", name));
    }
    ReadInstallation read = InstallationText.read(text);
    if (!read.problems().isEmpty()) {
      TextProblem first = read.problems().getFirst();
      int others = read.problems().size() - 1;
      String place = name + ":" + first.line() + ":" + first.column();
      throw new InstallationTrouble(
          others > 0
              ? InstallationFileTexts.text("severalProblems", place, first.message(), others)
              : place + ": " + first.message());
    }
    return read.installation();
  }
}
