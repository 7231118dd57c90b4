package org.pendant.desktop.editor.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.service.Completion;

/**
 * Insertion: what choosing a completion does to the text.
 *
 * @param edit the change
 * @param caret where the caret stands after it
 * @param arguments where the arguments that are to be filled in stand after it; may be empty
 */
public record Insertion(Edit edit, int caret, List<TextSpan> arguments) {
  private static final String SEPARATOR = ", ";

  /** Copies the places. */
  public Insertion {
    arguments = List.copyOf(arguments);
  }

  /**
   * Puts {@code completion} in place of the word around {@code caret}, which may have grown since
   * the completion was offered.
   *
   * @param text the text as it is now
   * @param start where that word begins, in characters
   */
  public static Insertion of(Completion completion, String text, int start, int caret) {
    Edit edit = Edit.replace(start, wordEnd(text, caret), completion.insert());
    return new Insertion(edit, start + completion.caret(), List.of());
  }

  /** The same, with the names of arguments at the caret as places to fill in. */
  public static Insertion withArguments(Completion completion, String text, int start, int caret) {
    List<TextSpan> arguments = new ArrayList<>();
    int at = start + completion.caret();
    for (String name : completion.arguments()) {
      arguments.add(new TextSpan(at, at + name.length()));
      at += name.length() + SEPARATOR.length();
    }
    String insert =
        new StringBuilder(completion.insert())
            .insert(completion.caret(), String.join(SEPARATOR, completion.arguments()))
            .toString();
    Edit edit = Edit.replace(start, wordEnd(text, caret), insert);
    return new Insertion(edit, start + completion.caret(), arguments);
  }

  private static int wordEnd(String text, int caret) {
    int end = caret;
    while (end < text.length() && isWord(text.charAt(end))) {
      end++;
    }
    return end;
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
