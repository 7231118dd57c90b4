package org.pendant.project.program.text;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.text.LineText.Value;

/** Step reader: puts a record together from the fields of a line. */
final class StepReader {
  private final LineText line;
  private final int column;
  private final Map<String, Value> unread;
  private final List<String> known = new ArrayList<>();

  /**
   * @param column where the line begins, for what is missing
   */
  StepReader(LineText line, int column) {
    this.line = line;
    this.column = column;
    unread = new LinkedHashMap<>(line.fields());
  }

  /**
   * The record.
   *
   * @param blocks the lines below the node, by the names of the components that hold them
   * @throws WrongText for a field that is missing, wrong or not known
   */
  <R extends Record> R read(Class<R> type, Map<String, List<?>> blocks) throws WrongText {
    R read = record(type, blocks);
    if (!unread.isEmpty()) {
      var first = unread.entrySet().iterator().next();
      throw new WrongText(
          // the key and = stand before the value
          first.getValue().column() - first.getKey().length() - 1,
          known.isEmpty()
              ? ProgramLineTexts.text("noFieldsAtAll", line.word(), first.getKey())
              : ProgramLineTexts.text(
                  "noField", line.word(), first.getKey(), String.join(", ", known)));
    }
    return read;
  }

  private <R extends Record> R record(Class<R> type, Map<String, List<?>> blocks) throws WrongText {
    RecordComponent[] components = type.getRecordComponents();
    Object[] values = new Object[components.length];
    for (int i = 0; i < components.length; i++) {
      values[i] =
          Forms.block(components[i])
              ? blocks.getOrDefault(components[i].getName(), List.of())
              : component(components[i]);
    }
    return Components.make(type, values);
  }

  private Object component(RecordComponent component) throws WrongText {
    Class<?> type = component.getType();
    String key = Forms.kebab(component.getName());
    known.add(key);
    Value value = unread.remove(key);
    if (type == boolean.class) {
      return value != null && flag(key, value);
    }
    if (type == String.class) {
      return value == null ? "" : text(key, value);
    }
    if (type == OptionalDouble.class) {
      return value == null ? OptionalDouble.empty() : OptionalDouble.of(number(key, value));
    }
    if (type == List.class) {
      ParameterizedType list = (ParameterizedType) component.getGenericType();
      return value == null ? List.of() : items(key, value, list.getActualTypeArguments()[0]);
    }
    if (type.isSealed()) {
      return variant(key, type, value);
    }
    Value there = required(key, value);
    if (type == double.class) {
      return number(key, there);
    }
    if (type == int.class) {
      return whole(key, there);
    }
    if (type == Pose.class) {
      return Pose.of(numbers(key, there, Pose.SIZE));
    }
    if (type == Joints.class) {
      return Joints.of(numbers(key, there, Joints.COUNT));
    }
    if (type.isEnum()) {
      return constant(key, type, there);
    }
    throw new IllegalStateException(key + " is a " + type);
  }

  private Value required(String key, Value value) throws WrongText {
    if (value == null) {
      throw new WrongText(column, ProgramLineTexts.text("fieldMissing", line.word(), key));
    }
    return value;
  }

  private Object variant(String key, Class<?> family, Value value) throws WrongText {
    Class<?> usual = Components.usual(family);
    if (value == null && usual != null) {
      return Components.make(usual.asSubclass(Record.class));
    }
    List<Class<? extends Record>> variants = Forms.variants(family);
    String word = word(key, required(key, value));
    for (Class<? extends Record> each : variants) {
      if (Forms.word(each).equals(word)) {
        return record(each, Map.of());
      }
    }
    throw wrong(
        key,
        value,
        ProgramLineTexts.text(
            "oneOf", variants.stream().map(Forms::word).collect(Collectors.joining(", "))));
  }

  private static Object constant(String key, Class<?> type, Value value) throws WrongText {
    String word = word(key, value);
    List<String> words = new ArrayList<>();
    for (Object each : type.getEnumConstants()) {
      words.add(Forms.word((Enum<?>) each));
      if (words.getLast().equals(word)) {
        return each;
      }
    }
    throw wrong(key, value, ProgramLineTexts.text("oneOf", String.join(", ", words)));
  }

  private static List<?> items(String key, Value value, java.lang.reflect.Type type)
      throws WrongText {
    if (!(value instanceof Value.Items items)) {
      throw wrong(key, value, ProgramLineTexts.text("list"));
    }
    List<Object> list = new ArrayList<>();
    for (Value each : items.values()) {
      if (type == Double.class) {
        list.add(number(key, each));
      } else if (type == Boolean.class) {
        list.add(flag(key, each));
      } else {
        list.add(text(key, each));
      }
    }
    return list;
  }

  /** So many numbers in brackets. */
  static double[] numbers(String key, Value value, int count) throws WrongText {
    if (!(value instanceof Value.Items items) || items.values().size() != count) {
      throw wrong(key, value, ProgramLineTexts.text("numberList", count));
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = number(key, items.values().get(i));
    }
    return numbers;
  }

  private static double number(String key, Value value) throws WrongText {
    if (value instanceof Value.Word word) {
      try {
        double number = Double.parseDouble(word.text());
        if (Double.isFinite(number) && word.text().matches("[-+0-9.eE]+")) {
          return number;
        }
      } catch (NumberFormatException e) {
        throw wrong(key, value, ProgramLineTexts.text("aNumber"));
      }
    }
    throw wrong(key, value, ProgramLineTexts.text("aNumber"));
  }

  private static int whole(String key, Value value) throws WrongText {
    double number = number(key, value);
    if (number != Math.rint(number) || Math.abs(number) > 1e9) {
      throw wrong(key, value, ProgramLineTexts.text("wholeNumber"));
    }
    return (int) number;
  }

  private static boolean flag(String key, Value value) throws WrongText {
    String word = word(key, value);
    if (!word.equals("true") && !word.equals("false")) {
      throw wrong(key, value, ProgramLineTexts.text("trueOrFalse"));
    }
    return word.equals("true");
  }

  /** A text in quotes. */
  static String text(String key, Value value) throws WrongText {
    if (value instanceof Value.Quoted quoted) {
      return quoted.text();
    }
    throw wrong(key, value, ProgramLineTexts.text("quotedText"));
  }

  private static String word(String key, Value value) throws WrongText {
    if (value instanceof Value.Word word) {
      return word.text();
    }
    throw wrong(key, value, ProgramLineTexts.text("plainWord"));
  }

  private static WrongText wrong(String key, Value value, String expected) {
    String message =
        switch (value) {
          case Value.Quoted quoted ->
              ProgramLineTexts.text("wrongValue", key, LineText.quoted(quoted.text()), expected);
          case Value.Word word -> ProgramLineTexts.text("wrongValue", key, word.text(), expected);
          case Value.Items items ->
              ProgramLineTexts.text("listInstead", key, items.values().size(), expected);
        };
    return new WrongText(value.column(), message);
  }
}
