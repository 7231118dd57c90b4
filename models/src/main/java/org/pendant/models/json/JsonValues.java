package org.pendant.models.json;

import java.util.Arrays;
import java.util.stream.Collectors;
import tools.jackson.core.io.JsonStringEncoder;

/** JSON values: as a file says them, for people to read. */
public final class JsonValues {
  private JsonValues() {}

  /** Any value, on one line. */
  public static String of(Json value) {
    return switch (value) {
      case Json.Text text -> text(text.value());
      case Json.Numeral number -> number(number.value());
      case Json.Word word -> word.word();
      case Json.Elements array ->
          array.values().stream().map(JsonValues::of).collect(Collectors.joining(", ", "[", "]"));
      case Json.Members object ->
          object.byKey().entrySet().stream()
              .map(each -> text(each.getKey()) + ": " + of(each.getValue().value()))
              .collect(Collectors.joining(", ", "{", "}"));
    };
  }

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
