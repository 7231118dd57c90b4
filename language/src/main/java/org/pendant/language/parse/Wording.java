package org.pendant.language.parse;

import static org.pendant.language.parse.ParseTexts.text;

import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression;

/** Wording of messages: how they show pieces of a script. */
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
    String shown = shortened(source.text(expression.range()));
    if (followsDigit(source, expression.range())) {
      return behindNumber(source, expression.range());
    }
    return switch (expression) {
      case Expression.PoseLiteral _ -> text("poseAlone", shown);
      case Expression.Index _ -> text("elementAlone", shown, shown);
      default -> text("expressionAlone", shown, shown, shown);
    };
  }

  /** What is wrong with a name that stands at the end of a number without a blank between. */
  static String behindNumber(Source source, SourceRange letters) {
    String text = source.text();
    String found = source.text(letters);
    if (!found.equalsIgnoreCase("e")) {
      return text("lettersBehindNumber", shortened(found));
    }
    int start = letters.start();
    while (start > 0
        && (Character.isDigit(text.charAt(start - 1)) || text.charAt(start - 1) == '.')) {
      start--;
    }
    int end = letters.end();
    boolean signed = end < text.length() && (text.charAt(end) == '-' || text.charAt(end) == '+');
    return text("exponentMissing", shortened(text.substring(start, signed ? end + 1 : end)));
  }

  /** Whether a digit stands directly before {@code range}. */
  static boolean followsDigit(Source source, SourceRange range) {
    int before = range.start() - 1;
    return before >= 0 && Character.isDigit(source.text().charAt(before));
  }
}
