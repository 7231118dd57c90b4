package org.pendant.models.json;

import java.util.Arrays;
import java.util.stream.Collectors;
import tools.jackson.core.io.JsonStringEncoder;

/** JSON values: as a file says them, for people to read. */
public final class JsonValues {
  private JsonValues() {}

  /** A text in quotation marks, with what JSON wants escaped. */
  public static String text(String value) {
    return '"' + new String(JsonStringEncoder.getInstance().quoteAsCharArray(value)) + '"';
  }

  /**
   * A number in as few digits as say it, without a fraction of zero.
   *
   * @param value finite
   */
  public static String number(double value) {
    String text = Double.toString(value == 0 ? 0 : value);
    return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
  }

  /** An array of numbers, on one line. */
  public static String numbers(double... values) {
    return Arrays.stream(values)
        .mapToObj(JsonValues::number)
        .collect(Collectors.joining(", ", "[", "]"));
  }
}
