package org.pendant.desktop.unit;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Sentence units: numbers within sentences of the controller, which counts in m and rad, in the
 * units that people have chosen.
 */
public final class SentenceUnits {
  private static final MathContext DIGITS = new MathContext(4);

  /**
   * Names that people gave are quoted: what looks like a number there is none. A unit ends where no
   * letter of any language that puts spaces between words follows.
   */
  private static final Pattern IN_SENTENCE =
      Pattern.compile(
          "\"[^\"]*\"|(?<![\\w\\p{IsLatin}.])(?<number>-?\\d+(\\.\\d+)?)"
              + " (?<unit>rad/s|rad|m/s|m)(?![\\w\\p{IsLatin}/\u00b2])");

  private SentenceUnits() {}

  /** A sentence with its lengths, angles and speeds as people read them. */
  public static String in(String sentence, PoseForm form) {
    return IN_SENTENCE
        .matcher(sentence)
        .replaceAll(
            found ->
                Matcher.quoteReplacement(
                    found.group("number") == null
                        ? found.group()
                        : measured(
                            Double.parseDouble(found.group("number")), found.group("unit"), form)));
  }

  /**
   * A number as people read it.
   *
   * @param unit what the controller counts it in, such as {@code m/s}
   */
  public static String measured(double value, String unit, PoseForm form) {
    return switch (unit) {
      case "m" -> form.length().reading(value);
      case "m/s" -> form.length().reading(value) + "/s";
      case "rad" -> form.angle().reading(value);
      case "rad/s" -> form.angle().reading(value) + "/s";
      default -> number(value) + " " + unit;
    };
  }

  private static String number(double value) {
    return Double.isFinite(value)
        ? new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString()
        : Double.toString(value);
  }
}
