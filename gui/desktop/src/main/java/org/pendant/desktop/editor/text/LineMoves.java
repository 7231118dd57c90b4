package org.pendant.desktop.editor.text;

import java.util.List;
import java.util.Optional;

/**
 * Line moves: edits of whole lines.
 *
 * @param edit what changes
 * @param shift by how many characters the selection moves with its lines
 */
public record LineMoves(Edit edit, int shift) {

  /** Moves the lines over the one above or below them; nothing at the edge of the text. */
  public static Optional<LineMoves> moved(String text, List<TextSpan> lines, boolean down) {
    int start = lines.getFirst().start();
    int end = lines.getLast().end();
    String moving = text.substring(start, end);
    if (down) {
      if (end >= text.length()) {
        return Optional.empty();
      }
      int nextEnd = endOfLine(text, end + 1);
      String next = text.substring(end + 1, nextEnd);
      return Optional.of(
          new LineMoves(Edit.replace(start, nextEnd, next + "\n" + moving), next.length() + 1));
    }
    if (start == 0) {
      return Optional.empty();
    }
    int previousStart = text.lastIndexOf('\n', start - 2) + 1;
    String previous = text.substring(previousStart, start - 1);
    return Optional.of(
        new LineMoves(
            Edit.replace(previousStart, end, moving + "\n" + previous), -previous.length() - 1));
  }

  /** Writes the lines once more below themselves; the selection goes there. */
  public static LineMoves duplicated(String text, List<TextSpan> lines) {
    int end = lines.getLast().end();
    String copy = "\n" + text.substring(lines.getFirst().start(), end);
    return new LineMoves(Edit.insert(end, copy), copy.length());
  }

  /** Takes the lines away. */
  public static Edit deleted(String text, List<TextSpan> lines) {
    int start = lines.getFirst().start();
    int end = lines.getLast().end();
    if (end < text.length()) {
      return Edit.replace(start, end + 1, "");
    }
    return Edit.replace(Math.max(0, start - 1), end, "");
  }

  private static int endOfLine(String text, int offset) {
    int newline = text.indexOf('\n', offset);
    return newline < 0 ? text.length() : newline;
  }
}
