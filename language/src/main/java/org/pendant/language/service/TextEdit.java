package org.pendant.language.service;

import java.nio.charset.StandardCharsets;
import java.util.Comparator;
import java.util.List;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Text edit: one change of a text.
 *
 * @param range the bytes to replace; empty to insert
 * @param text the new bytes, one {@code char} a byte as in {@link Source}
 */
public record TextEdit(SourceRange range, String text) {

  static TextEdit replace(int start, int end, String text) {
    return new TextEdit(new SourceRange(start, end), text);
  }

  static TextEdit insert(int offset, String text) {
    return replace(offset, offset, text);
  }

  /**
   * {@code source} with all of {@code edits} made; their ranges refer to the text before.
   *
   * @throws IllegalArgumentException if two of them overlap
   */
  public static Source apply(Source source, List<TextEdit> edits) {
    StringBuilder result = new StringBuilder(source.text().length() + 64);
    int done = 0;
    for (TextEdit edit : ordered(edits)) {
      if (edit.range.start() < done) {
        throw new IllegalArgumentException("the edit at " + edit.range + " overlaps another");
      }
      result.append(source.text(), done, edit.range.start()).append(edit.text);
      done = edit.range.end();
    }
    result.append(source.text(), done, source.text().length());
    return Source.of(source.name(), result.toString().getBytes(StandardCharsets.ISO_8859_1));
  }

  /** Where the byte at {@code offset} of the old text stands in the new one. */
  static int moved(int offset, List<TextEdit> edits) {
    int moved = offset;
    for (TextEdit edit : edits) {
      if (edit.range.end() <= offset) {
        moved += edit.text.length() - (edit.range.end() - edit.range.start());
      }
    }
    return moved;
  }

  private static List<TextEdit> ordered(List<TextEdit> edits) {
    return edits.stream()
        .sorted(Comparator.comparingInt((TextEdit edit) -> edit.range.start()))
        .toList();
  }
}
