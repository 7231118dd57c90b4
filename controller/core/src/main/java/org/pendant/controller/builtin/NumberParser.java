package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.math.BigInteger;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.script.function.Call;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueText;

/**
 * Number parser: reads the numbers that {@code to_num} accepts (manual 16.64).
 *
 * <p>A decimal point makes a float. Without one the number is an int and must fit 32 bits, unless a
 * negative exponent leaves a fraction: {@code 5e-4}, which the manual calls valid, is a float.
 */
final class NumberParser {
  /** Leading white space as C's isspace has it, a sign, then one of the four forms. */
  private static final Pattern NUMBER =
      Pattern.compile(
          "[ \\t\\n\\x0B\\f\\r]*([+-]?)"
              + "(?:0[xX](?<hex>[0-9a-fA-F]+)"
              + "|(?<word>[a-zA-Z]+)"
              + "|(?<decimal>(?:[0-9]+(?<point>\\.[0-9]*)?|(?<bare>\\.[0-9]+))"
              + "(?:[eE][+-]?[0-9]+)?))");

  /** Hexadecimal digits of the largest int. */
  private static final int MAX_DIGITS = 8;

  private static final int NS_A_BYTE = 10;

  /** Characters of the string that a message shows. */
  private static final int MAX_SHOWN = 80;

  private NumberParser() {}

  /** The number that argument 0 of {@code call} spells. */
  static Value parse(Call<?> call) throws ScriptError {
    call.charge(NS_A_BYTE * (long) call.text(0).length());
    Matcher text = NUMBER.matcher(call.text(0));
    if (!text.matches()) {
      throw notANumber(call);
    }
    boolean negative = text.group(1).equals("-");
    if (text.group("hex") != null) {
      return hexadecimal(call, negative, text.group("hex"));
    }
    if (text.group("word") != null) {
      return word(call, negative, text.group("word").toUpperCase(Locale.ROOT));
    }
    boolean point = text.group("point") != null || text.group("bare") != null;
    double magnitude = Double.parseDouble(text.group("decimal"));
    double number = negative ? -magnitude : magnitude;
    if (point || number != Math.rint(number)) {
      if (Double.isInfinite(number)) {
        throw outOfRange(call, "mustFitFloat");
      }
      return Value.of(number);
    }
    return integer(call, number);
  }

  private static Value hexadecimal(Call<?> call, boolean negative, String digits)
      throws ScriptError {
    String significant = digits.replaceFirst("^0+(?=.)", "");
    if (significant.length() > MAX_DIGITS) {
      // reading them would take time that grows with their square
      throw outOfRange(call, "mustFitInt");
    }
    BigInteger magnitude = new BigInteger(significant, 16);
    return integer(call, (negative ? magnitude.negate() : magnitude).doubleValue());
  }

  private static Value word(Call<?> call, boolean negative, String word) throws ScriptError {
    return switch (word) {
      case "INF", "INFINITY" ->
          Value.of(negative ? Double.NEGATIVE_INFINITY : Double.POSITIVE_INFINITY);
      case "NAN" -> Value.of(Double.NaN);
      default -> throw notANumber(call);
    };
  }

  private static Value integer(Call<?> call, double number) throws ScriptError {
    if (number != (int) number) {
      throw outOfRange(call, "mustFitInt");
    }
    return Value.of((int) number);
  }

  private static ScriptError notANumber(Call<?> call) {
    return call.failure("not-a-number", text("noNumber", shown(call)));
  }

  private static ScriptError outOfRange(Call<?> call, String refusal) {
    return call.failure("value-out-of-range", text(refusal, shown(call)));
  }

  private static String shown(Call<?> call) {
    return ValueText.shortened(call.value(0), MAX_SHOWN);
  }
}
