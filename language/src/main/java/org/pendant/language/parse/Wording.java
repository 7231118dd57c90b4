package org.pendant.language.parse;

import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;

/** How messages show pieces of a script. */
final class Wording {
  private static final int LONGEST = 24;

  private Wording() {}

  /**
   * {@code text}, cut where it grows too long for a message and free of control bytes. Other bytes
   * stay as they are: messages are bytes like the source, decoded where they are shown.
   */
  static String shortened(String text) {
    StringBuilder shown = new StringBuilder();
    int length = Math.min(text.length(), LONGEST);
    for (int i = 0; i < length; i++) {
      char found = text.charAt(i);
      if (found < ' ' || found == '\u007F') {
        shown.append(String.format("\\x%02X", (int) found));
      } else {
        shown.append(found);
      }
    }
    return text.length() > LONGEST ? shown.append("...").toString() : shown.toString();
  }

  /** Why {@code expression} is no statement. */
  static String noEffect(Source source, Expression expression) {
    String shown = "`" + shortened(source.text(expression.range())) + "`";
    if (followsDigit(source, expression.range())) {
      return "letters "
          + shown
          + " directly behind a number: a name cannot begin with a digit and there are no"
          + " hexadecimal numbers";
    }
    return shown
        + " does nothing on its own: expected `"
        + shortened(source.text(expression.range()))
        + " = ...` or a call, `"
        + shortened(source.text(expression.range()))
        + "(...)`";
  }

  /** Whether a digit stands directly before {@code range}. */
  static boolean followsDigit(Source source, SourceRange range) {
    int before = range.start() - 1;
    return before >= 0 && Character.isDigit(source.text().charAt(before));
  }
}
