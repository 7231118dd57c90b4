package org.pendant.command;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Paragraph: running text for a terminal. */
final class Paragraph {
  private Paragraph() {}

  /** {@code text} in lines of at most {@code width} characters, broken at blanks. */
  static List<String> wrap(String text, int width) {
    List<String> lines = new ArrayList<>();
    Optional<StringBuilder> line = Optional.empty();
    for (String word : text.trim().split("\\s+", -1)) {
      if (line.isPresent() && line.get().length() + 1 + word.length() <= width) {
        line.get().append(' ').append(word);
      } else {
        line.ifPresent(full -> lines.add(full.toString()));
        line = Optional.of(new StringBuilder(word));
      }
    }
    line.ifPresent(full -> lines.add(full.toString()));
    return lines;
  }
}
