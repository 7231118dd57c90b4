package org.pendant.project.installation.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.text.LineText;
import org.pendant.project.program.text.LineText.Value;
import org.pendant.project.program.text.WrongText;

/** Line fields: the fields of one line, asked for one by one; each is refused with its place. */
final class LineFields {
  private static final Pattern NUMBER =
      Pattern.compile("[+-]?(\\d+\\.?\\d*|\\.\\d+)([eE][+-]?\\d+)?");
  private static final Pattern WHOLE = Pattern.compile("[+-]?\\d{1,9}");

  private final LineText line;
  private final int column;
  private final Set<String> asked = new HashSet<>();

  /**
   * The fields of a line.
   *
   * @param column where the line begins, from 1
   */
  LineFields(LineText line, int column) {
    this.line = line;
    this.column = column;
  }

  /** Something wrong about the line as a whole. */
  WrongText wrong(String message) {
    return new WrongText(column, line.word() + ": " + message);
  }

  /** Refuses fields that were not asked for. */
  void requireAllKnown() throws WrongText {
    for (var each : line.fields().entrySet()) {
      if (!asked.contains(each.getKey())) {
        throw new WrongText(
            each.getValue().column(),
            asked.isEmpty()
                ? InstallationLineTexts.text("noFieldsAtAll", line.word(), each.getKey())
                : InstallationLineTexts.text(
                    "noField",
                    line.word(),
                    each.getKey(),
                    asked.stream().sorted().collect(Collectors.joining(", "))));
      }
    }
  }

  private Optional<Value> find(String key) {
    asked.add(key);
    return Optional.ofNullable(line.fields().get(key));
  }

  private Value require(String key) throws WrongText {
    Optional<Value> found = find(key);
    if (found.isEmpty()) {
      throw wrong(InstallationLineTexts.text("fieldMissing", key));
    }
    return found.get();
  }

  boolean has(String key) {
    return find(key).isPresent();
  }

  /** A text in quotes. */
  String text(String key) throws WrongText {
    return text(key, require(key));
  }

  /** A text in quotes; empty where there is none. */
  String textIfAny(String key) throws WrongText {
    Optional<Value> found = find(key);
    return found.isPresent() ? text(key, found.get()) : "";
  }

  private static String text(String key, Value value) throws WrongText {
    if (value instanceof Value.Quoted quoted) {
      return quoted.text();
    }
    throw new WrongText(value.column(), InstallationLineTexts.text("noText", key));
  }

  double number(String key) throws WrongText {
    return number(key, require(key), false);
  }

  private static double number(String key, Value value, boolean endless) throws WrongText {
    if (value instanceof Value.Word word) {
      if (endless && (word.text().equals("inf") || word.text().equals("-inf"))) {
        return word.text().equals("inf") ? Double.POSITIVE_INFINITY : Double.NEGATIVE_INFINITY;
      }
      if (NUMBER.matcher(word.text()).matches()
          && Double.isFinite(Double.parseDouble(word.text()))) {
        return Double.parseDouble(word.text());
      }
    }
    throw new WrongText(value.column(), InstallationLineTexts.text("noNumber", key, shown(value)));
  }

  /** A number, or {@code inf} or {@code -inf}. */
  double limit(String key) throws WrongText {
    return number(key, require(key), true);
  }

  int whole(String key) throws WrongText {
    return whole(key, require(key));
  }

  private static int whole(String key, Value value) throws WrongText {
    if (value instanceof Value.Word word && WHOLE.matcher(word.text()).matches()) {
      return Integer.parseInt(word.text());
    }
    throw new WrongText(
        value.column(), InstallationLineTexts.text("noWholeNumber", key, shown(value)));
  }

  /** Whole numbers in brackets. */
  List<Integer> wholes(String key) throws WrongText {
    List<Integer> all = new ArrayList<>();
    for (Value each : items(key, require(key))) {
      all.add(whole(key, each));
    }
    return all;
  }

  /** Half as many digits as {@link #number} has. */
  float small(String key) throws WrongText {
    Value value = require(key);
    number(key, value, false);
    return Float.parseFloat(((Value.Word) value).text());
  }

  /** So many numbers in brackets. */
  double[] numbers(String key, int count) throws WrongText {
    return numbers(key, count, false);
  }

  /** As {@link #numbers(String, int)}, where {@code inf} and {@code -inf} stand for no limit. */
  double[] limits(String key, int count) throws WrongText {
    return numbers(key, count, true);
  }

  private double[] numbers(String key, int count, boolean endless) throws WrongText {
    Value value = require(key);
    List<Value> items = items(key, value);
    if (items.size() != count) {
      throw new WrongText(
          value.column(), InstallationLineTexts.text("numberCount", key, items.size(), count));
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = number(key, items.get(i), endless);
    }
    return numbers;
  }

  private static List<Value> items(String key, Value value) throws WrongText {
    if (value instanceof Value.Items items) {
      return items.values();
    }
    throw new WrongText(value.column(), InstallationLineTexts.text("noList", key));
  }

  Pose pose(String key) throws WrongText {
    return Pose.of(numbers(key, Pose.SIZE));
  }

  Joints joints(String key) throws WrongText {
    return Joints.of(numbers(key, Joints.COUNT));
  }

  /** Whether it is true; what is left out is not. */
  boolean flag(String key) throws WrongText {
    return oneOf(key, "true", "false", false);
  }

  /** One of two words; {@code usual} where it is left out. */
  boolean oneOf(String key, String yes, String no, boolean usual) throws WrongText {
    Optional<Value> found = find(key);
    if (found.isEmpty()) {
      return usual;
    }
    if (found.get() instanceof Value.Word word
        && (word.text().equals(yes) || word.text().equals(no))) {
      return word.text().equals(yes);
    }
    throw new WrongText(
        found.get().column(),
        InstallationLineTexts.text("neitherOf", key, shown(found.get()), yes, no));
  }

  <E extends Enum<E>> E constant(String key, Class<E> type) throws WrongText {
    return constant(key, require(key), type);
  }

  /** A constant; {@code usual} where it is left out. */
  <E extends Enum<E>> E constant(String key, Class<E> type, E usual) throws WrongText {
    Optional<Value> found = find(key);
    return found.isPresent() ? constant(key, found.get(), type) : usual;
  }

  /** So many constants in brackets. */
  <E extends Enum<E>> List<E> constants(String key, Class<E> type, int count) throws WrongText {
    Value value = require(key);
    List<E> all = new ArrayList<>();
    for (Value each : items(key, value)) {
      all.add(constant(key, each, type));
    }
    if (all.size() != count) {
      throw new WrongText(
          value.column(), InstallationLineTexts.text("wordCount", key, all.size(), count));
    }
    return all;
  }

  private static <E extends Enum<E>> E constant(String key, Value value, Class<E> type)
      throws WrongText {
    if (value instanceof Value.Word word) {
      for (E each : type.getEnumConstants()) {
        if (Words.of(each).equals(word.text())) {
          return each;
        }
      }
    }
    String words =
        Stream.of(type.getEnumConstants()).map(Words::of).collect(Collectors.joining(", "));
    throw new WrongText(
        value.column(), InstallationLineTexts.text("noneOf", key, shown(value), words));
  }

  private static String shown(Value value) {
    return switch (value) {
      case Value.Quoted quoted -> LineText.quoted(quoted.text());
      case Value.Word word -> word.text();
      case Value.Items _ -> "a list";
    };
  }
}
