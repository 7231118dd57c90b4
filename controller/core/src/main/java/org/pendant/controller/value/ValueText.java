package org.pendant.controller.value;

import java.math.BigDecimal;
import java.math.RoundingMode;

/**
 * How values print (manual 16.57, 16.65).
 *
 * <p>Floats print as C's {@code %f} does, with six decimals rounded to nearest from the exact
 * binary value, then without trailing zeros and without a bare point; the manual leaves the sign of
 * zero open, here a value that rounds to zero prints as {@code 0}. A string is itself at the top
 * and stands in double quotes within lists and structs. Structs print as {@code {a = 1, b = "x"}},
 * matrices as a list of rows.
 */
public final class ValueText {
  private static final int DECIMALS = 6;
  private static final double SCALE = 1e6;
  private static final long SCALE_LONG = 1_000_000;
  private static final int WHOLE_NS = 12;
  private static final int FRACTION_NS = 35;
  private static final int EXACT_NS = 1500;

  /** Below this magnitude a scaled value is so precise that most roundings can be decided on it. */
  private static final double FAST_LIMIT = 1e9;

  private ValueText() {}

  /** The text of {@code value}, one {@code char} a byte. */
  public static String of(Value value) {
    return start(value, Integer.MAX_VALUE - 1);
  }

  /**
   * The beginning of the text of {@code value}: all of it, or a few more than {@code limit}
   * characters.
   */
  public static String start(Value value, int limit) {
    // not a pattern switch: those cost the start of every short program
    if (value instanceof StringValue string) {
      return string.length() <= limit ? string.bytes() : string.start(limit + 1);
    }
    if (value instanceof IntValue number) {
      return Integer.toString(number.value());
    }
    if (value instanceof FloatValue number) {
      return number(number.value());
    }
    if (value instanceof BoolValue bool) {
      return bool(bool.value());
    }
    if (value == NoneValue.NONE) {
      return "None";
    }
    TextConversion conversion = new TextConversion(limit, value);
    while (!conversion.done()) {
      conversion.advance();
    }
    return conversion.result().bytes();
  }

  /**
   * Begins the texts of {@code values}, one behind the other; the result is a string.
   *
   * @param limit how many characters are enough; there may be a few more
   */
  public static LongOperation begin(int limit, Value... values) {
    return new TextConversion(limit, values.clone());
  }

  /**
   * The text of {@code value} when it is no longer than {@code limit}, otherwise its beginning with
   * {@code ...} before the closing bracket (manual 4.3).
   */
  public static String shortened(Value value, int limit) {
    String text = start(value, limit);
    return text.length() <= limit ? text : text.substring(0, limit - 4) + "..." + last(value, text);
  }

  /** The last character of the text of {@code value}, which begins as {@code start} does. */
  private static char last(Value value, String start) {
    return switch (value.kind()) {
      case LIST, MATRIX, POSE -> ']';
      case STRUCT -> '}';
      case STRING -> {
        String bytes = ((StringValue) value).bytes();
        yield bytes.charAt(bytes.length() - 1);
      }
      case NONE, BOOL, INT, FLOAT, HANDLE -> start.charAt(start.length() - 1);
    };
  }

  /** The text of a float. */
  public static String number(double number) {
    StringBuilder text = new StringBuilder(16);
    appendNumber(text, number);
    return text.toString();
  }

  static String bool(boolean value) {
    return value ? "True" : "False";
  }

  /**
   * Adds the text of a float.
   *
   * @return how long that takes, in nanoseconds, roughly
   */
  static int appendNumber(StringBuilder text, double number) {
    if (number == (long) number && Math.abs(number) < FAST_LIMIT) {
      text.append((long) number);
      return WHOLE_NS;
    }
    double scaled = Math.abs(number) * SCALE;
    double fraction = scaled - Math.floor(scaled);
    // the product is off by half a unit in its last place at most: only nearer to a tie than
    // that can the exact value round the other way
    if (Math.abs(number) < FAST_LIMIT && Math.abs(fraction - 0.5) > Math.ulp(scaled)) {
      appendScaled(text, number < 0, (long) Math.rint(scaled));
      return FRACTION_NS;
    }
    if (Double.isNaN(number)) {
      text.append("nan");
    } else if (Double.isInfinite(number)) {
      text.append(number < 0 ? "-inf" : "inf");
    } else {
      appendExact(text, number);
    }
    return EXACT_NS;
  }

  private static void appendScaled(StringBuilder text, boolean negative, long scaled) {
    if (negative && scaled != 0) {
      text.append('-');
    }
    text.append(scaled / SCALE_LONG);
    long decimals = scaled % SCALE_LONG;
    if (decimals != 0) {
      text.append('.');
      for (long place = SCALE_LONG / 10; decimals != 0; place /= 10) {
        text.append((char) ('0' + decimals / place));
        decimals %= place;
      }
    }
  }

  private static void appendExact(StringBuilder text, double number) {
    BigDecimal rounded = new BigDecimal(number).setScale(DECIMALS, RoundingMode.HALF_EVEN);
    text.append(rounded.signum() == 0 ? "0" : rounded.stripTrailingZeros().toPlainString());
  }
}
