package org.pendant.controller.message;

import java.util.Locale;
import java.util.regex.Pattern;

/**
 * Question: what a program wants to know of the operator (manual 18.73 to 18.76). The thread that
 * asks waits, everything else continues.
 *
 * @param number popups and questions are counted together, from 1
 * @param timeS controller time when it was asked, s
 * @param kind which answers it takes
 * @param text bytes, one {@code char} a byte; never empty
 */
public record Question(long number, double timeS, Kind kind, String text) {

  /** Which answers a question takes. */
  public enum Kind {
    BOOLEAN("boolean"),
    INTEGER("whole"),
    FLOAT("number"),
    STRING("bytes");

    private static final Pattern WHOLE = Pattern.compile("[+-]?0*\\d{1,10}");
    private static final Pattern DECIMAL =
        Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d{1,4})?");

    private final String key;

    Kind(String key) {
      this.key = key;
    }

    /** What an answer must be, in words that follow "must be". */
    public String expected() {
      return MessageTexts.text(key);
    }

    /**
     * Reads an answer that is written as text; blanks around numbers do not count.
     *
     * @param text bytes, one {@code char} a byte; {@code True}, {@code yes} or {@code 1} and their
     *     opposites for BOOLEAN, in capitals or not
     * @throws IllegalArgumentException if it is not one of this kind
     */
    public Answer read(String text) {
      String word = text.strip();
      return switch (this) {
        case BOOLEAN ->
            switch (word.toLowerCase(Locale.ROOT)) {
              case "true", "yes", "1" -> new Answer.Bool(true);
              case "false", "no", "0" -> new Answer.Bool(false);
              default -> throw refused(text);
            };
        case INTEGER -> new Answer.Whole(whole(text));
        case FLOAT -> {
          if (!DECIMAL.matcher(word).matches()) {
            throw refused(text);
          }
          yield fitting(new Answer.Decimal(Double.parseDouble(word)));
        }
        case STRING -> fitting(new Answer.Text(text));
      };
    }

    private int whole(String text) {
      String word = text.strip();
      if (!WHOLE.matcher(word).matches()) {
        throw refused(text);
      }
      long number = Long.parseLong(word);
      if (number != (int) number) {
        throw refused(text);
      }
      return (int) number;
    }

    /**
     * The answer as a program gets it: a whole number is a number as well.
     *
     * @throws IllegalArgumentException if this kind of question does not take it
     */
    public Answer fitting(Answer given) {
      return switch (given) {
        case Answer.Bool bool when this == BOOLEAN -> bool;
        case Answer.Whole whole when this == INTEGER -> whole;
        case Answer.Whole whole when this == FLOAT -> new Answer.Decimal(whole.value());
        case Answer.Decimal decimal when this == FLOAT && Double.isFinite(decimal.value()) ->
            decimal;
        case Answer.Text text
            when this == STRING && text.bytes().chars().allMatch(each -> each <= 0xFF) ->
            text;
        case Answer.Bool bool -> throw refused(bool.text());
        case Answer.Whole whole -> throw refused(whole.text());
        case Answer.Decimal decimal -> throw refused(decimal.text());
        case Answer.Text text -> throw refused(text.bytes());
      };
    }

    private IllegalArgumentException refused(String text) {
      return new IllegalArgumentException(
          text.isBlank()
              ? MessageTexts.text("emptyAnswer", expected())
              : MessageTexts.text("wrongAnswer", text, expected()));
    }
  }
}
