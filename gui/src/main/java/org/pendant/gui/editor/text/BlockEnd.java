package org.pendant.gui.editor.text;

import java.util.List;
import java.util.Set;

/** Whether a block that is being begun still needs its {@code end}. */
public final class BlockEnd {
  private static final Set<String> OPENERS = Set.of("def", "sec", "thread", "if", "while");

  private BlockEnd() {}

  /**
   * Whether the line at {@code index} is the head of a block without an end: the text as a whole
   * has fewer ends than heads, and no {@code end} stands under this one as deep as it.
   *
   * @param lines all lines, without their ends
   */
  public static boolean missing(List<String> lines, int index) {
    String head = AutoIndent.code(lines.get(index)).strip();
    return head.endsWith(":")
        && OPENERS.contains(AutoIndent.firstWord(head))
        && balance(head) > 0
        && lines.stream().mapToInt(line -> balance(AutoIndent.code(line))).sum() > 0
        && !isClosed(lines, index);
  }

  private static boolean isClosed(List<String> lines, int index) {
    int depth = AutoIndent.blanks(lines.get(index)).length();
    for (int i = index + 1; i < lines.size(); i++) {
      String code = AutoIndent.code(lines.get(i));
      if (!code.isBlank() && AutoIndent.blanks(code).length() <= depth) {
        String word = AutoIndent.firstWord(code);
        boolean part = word.equals("end") || word.equals("elif") || word.equals("else");
        return part && AutoIndent.blanks(code).length() == depth;
      }
    }
    return false;
  }

  /** Heads less ends in one line of code. */
  private static int balance(String code) {
    int balance = 0;
    boolean quoted = false;
    int start = -1;
    for (int i = 0; i <= code.length(); i++) {
      char c = i < code.length() ? code.charAt(i) : ' ';
      quoted ^= c == '"';
      boolean word = !quoted && Insertion.isWord(c);
      if (word && start < 0) {
        start = i;
      } else if (!word && start >= 0) {
        String found = code.substring(start, i);
        balance += found.equals("end") ? -1 : OPENERS.contains(found) ? 1 : 0;
        start = -1;
      }
    }
    return balance;
  }
}
