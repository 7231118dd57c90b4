package org.pendant.script.value;

import org.pendant.models.text.FloatText;

/**
 * Text of values: how they print (manual 16.57, 16.65).
 *
 * <p>Floats and poses print as {@link FloatText} says. A string is itself at the top and stands in
 * double quotes within lists and structs. Structs print as {@code {a = 1, b = "x"}}, matrices as a
 * list of rows.
 */
public final class ValueText {
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
      return FloatText.of(number.value());
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
   * Begins the texts of {@code values}, one after the other; the result is a string.
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

  static String bool(boolean value) {
    return value ? "True" : "False";
  }
}
