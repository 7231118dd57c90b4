package org.pendant.kit.export;

import static org.pendant.kit.export.SaveTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;

/**
 * Save request: what is to be saved, for the dialog that asks where.
 *
 * @param title of the question
 * @param suggestion the file unless people want otherwise; its folder is the first that is shown
 * @param endings file name endings, such as {@code csv}; people choose among them, and the chosen
 *     one is added where there is none; files of the others are hidden meanwhile
 * @param naming makes the name of the file of the one that people gave, such as by an ending that
 *     must be there
 * @param inUse files that are open, other than the one that is saved: they are not written onto
 */
public record SaveRequest(
    String title,
    Path suggestion,
    List<String> endings,
    UnaryOperator<Path> naming,
    List<Path> inUse) {
  public SaveRequest {
    endings = List.copyOf(endings);
    inUse = List.copyOf(inUse);
  }

  /** One that takes every name, and any file that is not in use. */
  public SaveRequest(String title, Path suggestion, List<String> endings, List<Path> inUse) {
    this(title, suggestion, endings, UnaryOperator.identity(), inUse);
  }

  /**
   * The file that a name stands for, with an ending if it has none.
   *
   * @param chosen that ending, one of {@link #endings}
   */
  Path file(Path named, String chosen) {
    String name = named.getFileName().toString();
    return naming.apply(name.contains(".") ? named : named.resolveSibling(name + "." + chosen));
  }

  /** A name with {@code chosen} in place of one of the other endings; others stay. */
  String withEnding(String name, String chosen) {
    return endings.stream()
        .filter(each -> name.endsWith("." + each))
        .findFirst()
        .map(each -> name.substring(0, name.length() - each.length()) + chosen)
        .orElse(name);
  }

  /** The ending that a name has, else the first. */
  String ending(String name) {
    return endings.stream()
        .filter(each -> name.endsWith("." + each))
        .findFirst()
        .orElse(endings.getFirst());
  }

  /** Why a file cannot be taken at all, as the end of the title. */
  Optional<String> refusal(Path file) {
    return inUse.stream().anyMatch(each -> same(each, file))
        ? Optional.of(text("isOpenInThisWindowChoose", file.getFileName()))
        : Optional.empty();
  }

  private static boolean same(Path one, Path other) {
    try {
      return Files.isSameFile(one, other);
    } catch (IOException e) {
      // A file that is not there cannot be overwritten.
      return false;
    }
  }
}
