package org.pendant.desktop.editor.text;

import java.util.Comparator;
import java.util.List;

/**
 * Edit: one change of an editor's text, counted in characters.
 *
 * @param span what goes; empty to insert
 * @param text what comes
 */
public record Edit(TextSpan span, String text) {

  /** Puts {@code text} in place of the characters from {@code start} to {@code end}. */
  public static Edit replace(int start, int end, String text) {
    return new Edit(new TextSpan(start, end), text);
  }

  /** Puts {@code text} at {@code offset}. */
  public static Edit insert(int offset, String text) {
    return replace(offset, offset, text);
  }

  /**
   * The smallest change that makes {@code now} of {@code old}, a stretch of text that begins at
   * {@code offset}: what is the same at its ends stays as it is, with all that is tied to it.
   */
  public static Edit difference(int offset, String old, String now) {
    int most = Math.min(old.length(), now.length());
    int start = 0;
    while (start < most && old.charAt(start) == now.charAt(start)) {
      start++;
    }
    int end = 0;
    while (end < most - start
        && old.charAt(old.length() - 1 - end) == now.charAt(now.length() - 1 - end)) {
      end++;
    }
    return replace(
        offset + start, offset + old.length() - end, now.substring(start, now.length() - end));
  }

  /** {@code edits} from the last to the first, so that each can be made without moving the next. */
  public static List<Edit> backwards(List<Edit> edits) {
    return edits.stream()
        .sorted(Comparator.comparingInt((Edit edit) -> edit.span.start()).reversed())
        .toList();
  }

  /** {@code text} with all of {@code edits} made; their spans refer to the text before. */
  public static String apply(String text, List<Edit> edits) {
    StringBuilder result = new StringBuilder(text);
    for (Edit edit : backwards(edits)) {
      result.replace(edit.span.start(), edit.span.end(), edit.text);
    }
    return result.toString();
  }

  /** Where the character at {@code offset} of the text before stands after {@code edits}. */
  public static int moved(int offset, List<Edit> edits) {
    int moved = offset;
    for (Edit edit : edits) {
      if (edit.span.end() <= offset) {
        moved += edit.text.length() - (edit.span.end() - edit.span.start());
      } else if (edit.span.start() < offset) {
        moved += Math.min(edit.text.length(), offset - edit.span.start());
        moved -= offset - edit.span.start();
      }
    }
    return moved;
  }
}
