package org.pendant.desktop.editor.text;

import org.pendant.language.service.Completion;

/**
 * Insertion: what choosing a completion does to the text.
 *
 * @param edit the change
 * @param caret where the caret stands after it
 */
public record Insertion(Edit edit, int caret) {

  /**
   * Puts {@code completion} in place of the word around {@code caret}, which may have grown since
   * the completion was offered.
   *
   * @param text the text as it is now
   * @param start where that word begins, in characters
   */
  public static Insertion of(Completion completion, String text, int start, int caret) {
    int end = caret;
    while (end < text.length() && isWord(text.charAt(end))) {
      end++;
    }
    String insert = completion.insert();
    return new Insertion(Edit.replace(start, end, insert), start + completion.caret());
  }

  /** Where the word begins that ends at or continues over {@code caret}. */
  public static int wordStart(CharSequence text, int caret) {
    int start = caret;
    while (start > 0 && isWord(text.charAt(start - 1))) {
      start--;
    }
    return start;
  }

  /** Whether {@code c} can be part of a name. */
  public static boolean isWord(char c) {
    return c == '_' || (c < 0x80 && Character.isLetterOrDigit(c));
  }
}
