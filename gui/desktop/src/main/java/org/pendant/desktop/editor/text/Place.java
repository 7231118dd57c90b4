package org.pendant.desktop.editor.text;

import java.nio.file.Path;
import java.util.Optional;

/**
 * A place in a program that a list of results leads to.
 *
 * @param name what people call the program
 * @param file where it is on disk; empty for one that has no file
 * @param line from 1
 * @param column in characters, from 1
 * @param length how many characters are meant
 * @param text the line, without its end
 */
public record Place(
    String name, Optional<Path> file, int line, int column, int length, String text) {

  /** The place of {@code span} in {@code text}. */
  public static Place of(String name, Optional<Path> file, String text, TextSpan span) {
    int start = text.lastIndexOf('\n', span.start() - 1) + 1;
    return new Place(
        name,
        file,
        LineIndex.number(text, span.start()),
        span.start() - start + 1,
        span.end() - span.start(),
        LineIndex.at(text, span.start()));
  }
}
