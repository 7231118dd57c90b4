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

  /** Below this magnitude a scaled value is so precise that most roundings can be decided on it. */
  private static final double FAST_LIMIT = 1e9;

  private ValueText() {}

  /** The text of {@code value}, one {@code char} a byte. */
  public static String of(Value value) {
    // not a pattern switch: those cost the start of every short program
    if (value instanceof StringValue string) {
      return string.bytes();
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
    StringBuilder text = new StringBuilder();
    append(text, value);
    return text.toString();
  }

  /**
   * The text of {@code value} when it is no longer than {@code limit}, otherwise its beginning with
   * {@code ...} before the closing bracket (manual 4.3).
   */
  public static String shortened(Value value, int limit) {
    String text = of(value);
    if (text.length() <= limit) {
      return text;
    }
    return text.substring(0, limit - 4) + "..." + text.charAt(text.length() - 1);
  }

  /** The text of a float. */
  public static String number(double number) {
    StringBuilder text = new StringBuilder(16);
    appendNumber(text, number);
    return text.toString();
  }

  private static String bool(boolean value) {
    return value ? "True" : "False";
  }

  private static void append(StringBuilder text, Value value) {
    switch (value) {
      case IntValue i -> text.append(i.value());
      case FloatValue f -> appendNumber(text, f.value());
      case BoolValue b -> text.append(bool(b.value()));
      case StringValue s -> text.append('"').append(s.bytes()).append('"');
      case NoneValue none -> text.append("None");
      case PoseValue pose -> {
        text.append('p');
        appendNumbers(text, pose.pose().toArray(), 0, 6, Kind.FLOAT);
      }
      case NumberList list ->
          appendNumbers(text, list.elements(), 0, list.length(), list.elementKind());
      case ObjectList list -> appendObjects(text, list);
      case MatrixValue matrix -> appendMatrix(text, matrix);
      case StructValue struct -> appendStruct(text, struct);
      case HandleValue handle -> {
        text.append(handle.type().text()).append(' ').append(handle.id());
        if (!handle.path().isEmpty()) {
          text.append('.').append(handle.path());
        }
      }
    }
  }

  private static void appendNumbers(
      StringBuilder text, double[] numbers, int from, int to, Kind kind) {
    text.append('[');
    for (int i = from; i < to; i++) {
      if (i > from) {
        text.append(", ");
      }
      if (kind == Kind.BOOL) {
        text.append(bool(numbers[i] != 0));
      } else {
        appendNumber(text, numbers[i]);
      }
    }
    text.append(']');
  }

  private static void appendObjects(StringBuilder text, ObjectList list) {
    text.append('[');
    for (int i = 0; i < list.length(); i++) {
      if (i > 0) {
        text.append(", ");
      }
      append(text, list.objectAt(i));
    }
    text.append(']');
  }

  private static void appendMatrix(StringBuilder text, MatrixValue matrix) {
    text.append('[');
    int columns = matrix.columns();
    for (int row = 0; row < matrix.rows(); row++) {
      if (row > 0) {
        text.append(", ");
      }
      appendNumbers(
          text, matrix.elements(), row * columns, (row + 1) * columns, matrix.elementKind());
    }
    text.append(']');
  }

  private static void appendStruct(StringBuilder text, StructValue struct) {
    text.append('{');
    for (int i = 0; i < struct.length(); i++) {
      if (i > 0) {
        text.append(", ");
      }
      text.append(struct.names().get(i)).append(" = ");
      append(text, struct.memberAt(i));
    }
    text.append('}');
  }

  private static void appendNumber(StringBuilder text, double number) {
    if (number == (long) number && Math.abs(number) < FAST_LIMIT) {
      text.append((long) number);
      return;
    }
    double scaled = Math.abs(number) * SCALE;
    double fraction = scaled - Math.floor(scaled);
    // the product is off by half a unit in its last place at most: only nearer to a tie than
    // that can the exact value round the other way
    if (Math.abs(number) < FAST_LIMIT && Math.abs(fraction - 0.5) > Math.ulp(scaled)) {
      appendScaled(text, number < 0, (long) Math.rint(scaled));
    } else if (Double.isNaN(number)) {
      text.append("nan");
    } else if (Double.isInfinite(number)) {
      text.append(number < 0 ? "-inf" : "inf");
    } else {
      appendExact(text, number);
    }
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
