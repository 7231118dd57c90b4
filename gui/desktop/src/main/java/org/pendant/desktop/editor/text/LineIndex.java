package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.List;

/** Line index: the lines of a text. */
public final class LineIndex {
  private LineIndex() {}

  /** The lines that {@code span} touches, without their ends; a line it ends before is not one. */
  public static List<TextSpan> touched(String text, TextSpan span) {
    List<TextSpan> lines = new ArrayList<>();
    int start = text.lastIndexOf('\n', span.start() - 1) + 1;
    do {
      int newline = text.indexOf('\n', start);
      int end = newline < 0 ? text.length() : newline;
      lines.add(new TextSpan(start, end));
      start = end + 1;
    } while (start < span.end());
    return lines;
  }

  /** The line of {@code offset}, from 1. */
  public static int number(CharSequence text, int offset) {
    int line = 1;
    for (int i = 0; i < offset; i++) {
      if (text.charAt(i) == '\n') {
        line++;
      }
    }
    return line;
  }

  /** The line that holds {@code offset}, without its end. */
  public static String at(String text, int offset) {
    int start = text.lastIndexOf('\n', offset - 1) + 1;
    int newline = text.indexOf('\n', offset);
    return text.substring(start, newline < 0 ? text.length() : newline);
  }
}
