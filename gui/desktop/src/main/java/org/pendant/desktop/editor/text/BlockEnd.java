package org.pendant.desktop.editor.text;

import java.util.Set;
import java.util.function.IntFunction;
import java.util.stream.IntStream;

/** Block end: whether a block that is being begun still needs its {@code end}. */
public final class BlockEnd {
  private static final Set<String> OPENERS = Set.of("def", "sec", "thread", "if", "while");

  private static final int MAX_COUNTED = 20_000;

  private BlockEnd() {}

  /**
   * Whether a line is the head of a block without an end: no {@code end} stands under it as deep as
   * it, and the text as a whole has fewer ends than heads. Texts of very many lines are not counted
   * through: there the depth alone decides.
   *
   * @param lines each line without its end, by its number from 0
   * @param count how many lines there are
   * @param head the number of the line
   */
  public static boolean missing(IntFunction<String> lines, int count, int head) {
    String code = AutoIndent.code(lines.apply(head)).strip();
    return code.endsWith(":")
        && OPENERS.contains(AutoIndent.firstWord(code))
        && balance(code) > 0
        && !isClosed(lines, count, head)
        && (count > MAX_COUNTED
            || IntStream.range(0, count)
                    .map(line -> balance(AutoIndent.code(lines.apply(line))))
                    .sum()
                > 0);
  }

  private static boolean isClosed(IntFunction<String> lines, int count, int head) {
    int depth = AutoIndent.blanks(lines.apply(head)).length();
    for (int i = head + 1; i < count; i++) {
      String code = AutoIndent.code(lines.apply(i));
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
