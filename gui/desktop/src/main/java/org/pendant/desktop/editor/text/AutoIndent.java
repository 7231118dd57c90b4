package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Automatic indentation: how lines are indented while they are typed. Lines are given without their
 * ends.
 */
public final class AutoIndent {
  /** The blanks of one step. */
  public static final int STEP = 2;

  private static final Set<String> CLOSERS = Set.of("end", "else:", "elif");
  private static final Set<String> OPENERS =
      Set.of("def", "sec", "thread", "if", "elif", "else", "while");

  private AutoIndent() {}

  /**
   * The blanks of a line that is begun behind {@code before}, the part of the line before the
   * caret: deeper behind the head of a block.
   */
  public static String behind(String before) {
    String code = code(before).stripTrailing();
    boolean opens = code.endsWith(":") && OPENERS.contains(firstWord(code));
    return blanks(before) + (opens ? " ".repeat(STEP) : "");
  }

  /**
   * The blanks that {@code line} should have when it has just become the end or the next part of a
   * block: those of the head that it belongs to. Any other line keeps its own.
   *
   * @param above the lines over it, the first first
   */
  public static String of(String line, List<String> above) {
    String code = line.strip();
    if (!CLOSERS.contains(code)) {
      return blanks(line);
    }
    int depth = 0;
    for (int i = above.size() - 1; i >= 0; i--) {
      String other = code(above.get(i)).strip();
      String word = firstWord(other);
      if (word.equals("end")) {
        depth++;
      } else if (OPENERS.contains(word) && !word.equals("else") && !word.equals("elif")) {
        boolean oneLine = other.endsWith(" end");
        if (!oneLine && depth == 0) {
          return blanks(above.get(i));
        }
        depth -= oneLine ? 0 : 1;
      }
    }
    return blanks(line);
  }

  /** The edits that move lines one step in or out; blank lines stay when they go in. */
  public static List<Edit> shifted(List<TextSpan> lines, String text, boolean deeper) {
    List<Edit> edits = new ArrayList<>();
    for (TextSpan line : lines) {
      String content = text.substring(line.start(), line.end());
      int own = blanks(content).length();
      if (deeper && !content.isBlank()) {
        edits.add(Edit.insert(line.start(), " ".repeat(STEP - own % STEP)));
      } else if (!deeper && own > 0) {
        int less = own % STEP == 0 ? STEP : own % STEP;
        edits.add(Edit.replace(line.start(), line.start() + Math.min(own, less), ""));
      }
    }
    return edits;
  }

  /** The blanks that a line begins with. */
  public static String blanks(String line) {
    return line.substring(0, line.length() - line.stripLeading().length());
  }

  static String firstWord(String code) {
    String stripped = code.stripLeading();
    int end = 0;
    while (end < stripped.length() && Character.isLetter(stripped.charAt(end))) {
      end++;
    }
    return stripped.substring(0, end);
  }

  /** A line without its comment. */
  static String code(String line) {
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"') {
        quoted = !quoted;
      } else if (c == '#' && !quoted) {
        return line.substring(0, i);
      }
    }
    return line;
  }
}
