package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.List;

/** Comment toggle: makes lines comments, or code again when all of them are comments. */
public final class CommentToggle {
  private CommentToggle() {}

  /**
   * The edits for {@code lines} of {@code text}; blank lines are left alone. Marks stand in one
   * column, that of the line that is indented least.
   */
  public static List<Edit> edits(String text, List<TextSpan> lines) {
    List<TextSpan> filled =
        lines.stream().filter(line -> !text.substring(line.start(), line.end()).isBlank()).toList();
    boolean all = filled.stream().allMatch(line -> text.charAt(first(text, line)) == '#');
    int column = filled.stream().mapToInt(line -> first(text, line) - line.start()).min().orElse(0);
    List<Edit> edits = new ArrayList<>();
    for (TextSpan line : filled) {
      if (all) {
        int mark = first(text, line);
        boolean blank = mark + 1 < line.end() && text.charAt(mark + 1) == ' ';
        edits.add(Edit.replace(mark, mark + (blank ? 2 : 1), ""));
      } else {
        edits.add(Edit.insert(line.start() + column, "# "));
      }
    }
    return edits;
  }

  private static int first(String text, TextSpan line) {
    int at = line.start();
    while (Character.isWhitespace(text.charAt(at))) {
      at++;
    }
    return at;
  }
}
