package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.service.HighlightToken.Style;

/**
 * Styled line: the colours of one line.
 *
 * @param text the line without its end; colours of another text are of no use
 * @param runs its coloured stretches, in order
 */
public record StyledLine(String text, List<Run> runs) {

  /** A stretch of one colour; offsets count characters from the line's start. */
  public record Run(Style style, int start, int end) {}

  public StyledLine {
    runs = List.copyOf(runs);
  }

  /** Whether these are the colours of {@code line}. */
  boolean isOf(CharSequence line) {
    return text.contentEquals(line);
  }

  /** Collects the runs of one line. */
  static final class Builder {
    private final List<Run> runs = new ArrayList<>();

    void add(Style style, int start, int end) {
      if (end > start) {
        runs.add(new Run(style, start, end));
      }
    }

    StyledLine of(String text) {
      return new StyledLine(text, runs);
    }
  }
}
