package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.ControllerOptions;
import org.pendant.language.check.Nearest;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmFile;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.json.JsonException;

/** Robot name: the arm that a word of the command line means, by name or by a file. */
final class RobotName {
  private RobotName() {}

  /**
   * The id of the arm called {@code word}.
   *
   * @param what says which option or operand, for the message
   * @throws UsageException if there is no such arm; the message names all, and the likely one
   */
  static String idOf(Supplier<String> what, String word) throws UsageException {
    Optional<String> id = ArmLibrary.find(word);
    if (id.isPresent()) {
      return id.get();
    }
    throw new UsageException(
        text(
            "mustBeOneOf",
            what.get(),
            word,
            String.join(", ", ArmLibrary.ids()),
            likely(word.toLowerCase(Locale.ROOT)).map(n -> text("didYouMeanLast", n)).orElse("")));
  }

  /** Whether {@code word} is the name of an arm file and of no model. */
  static boolean isFile(String word) {
    return word.toLowerCase(Locale.ROOT).endsWith(".json");
  }

  /**
   * Reads an arm file.
   *
   * @throws UsageException if it cannot be read or is none; the message says where and why
   */
  static ArmDescription read(String name, SourceFiles files) throws UsageException {
    try (InputStream in = Files.newInputStream(files.path("theArmFile", name))) {
      return ArmFile.read(name, in);
    } catch (JsonException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw SourceFiles.unreadable(name, e);
    }
  }

  /**
   * The arm that {@link RunOptions#ROBOT} names, or else the default one.
   *
   * @throws UsageException if there is no such arm
   */
  static ArmDescription model(Arguments arguments) throws UsageException {
    String robot = arguments.value(RunOptions.ROBOT).orElse(ControllerOptions.DEFAULT_ROBOT);
    return isFile(robot)
        ? read(robot, arguments.files())
        : ArmLibrary.load(idOf(RunOptions.ROBOT::name, robot));
  }

  /** The only id that continues where the word ends ({@code ur16}), or else the nearest. */
  private static Optional<String> likely(String word) {
    List<String> longer = ArmLibrary.ids().stream().filter(id -> id.startsWith(word)).toList();
    return longer.size() == 1
        ? Optional.of(longer.getFirst())
        : new Nearest().to(word, ArmLibrary::ids);
  }
}
