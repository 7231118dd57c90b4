package org.pendant.sweep.plan;

import static org.pendant.sweep.plan.PlanTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.pendant.language.check.Nearest;
import org.tomlj.TomlArray;
import org.tomlj.TomlPosition;
import org.tomlj.TomlTable;

/**
 * Fields of a table in a TOML file. What is wrong is noted with its place, and reading goes on, so
 * that a user sees all mistakes at once.
 */
final class TomlFields {
  private final String file;
  private final TomlTable table;
  private final String what;
  private final TomlPosition place;
  private final List<String> mistakes;

  /**
   * The fields of a table.
   *
   * @param what the table is, for messages, such as {@code the plan}
   * @param place where it begins
   * @param mistakes takes what is wrong
   */
  TomlFields(String file, TomlTable table, String what, TomlPosition place, List<String> mistakes) {
    this.file = file;
    this.table = table;
    this.what = what;
    this.place = place;
    this.mistakes = mistakes;
  }

  /** Notes a mistake at a key, or at the table where the key is missing. */
  void wrong(String key, String message) {
    TomlPosition at = table.contains(List.of(key)) ? table.inputPositionOf(List.of(key)) : null;
    mistakes.add(report(file, at == null ? place : at, message));
  }

  /** A mistake with its place. */
  static String report(String file, TomlPosition at, String message) {
    return file + ":" + at.line() + ":" + at.column() + ": error: " + message;
  }

  /** Refuses all keys but these. */
  void allow(String... keys) {
    List<String> legal = Arrays.asList(keys);
    for (String key : table.keySet()) {
      if (!legal.contains(key)) {
        wrong(
            key,
            new Nearest()
                .to(key, () -> legal)
                .map(near -> PlanTexts.text("unknownKeyDidYouMean", key, what, near))
                .orElseGet(
                    () -> PlanTexts.text("unknownKeyOneOf", key, what, String.join(", ", legal))));
      }
    }
  }

  boolean has(String key) {
    return table.contains(List.of(key));
  }

  private <T> Optional<T> value(String key, Class<T> type, String expected) {
    Object found = table.get(List.of(key));
    if (found == null) {
      return Optional.empty();
    }
    if (!type.isInstance(found)) {
      wrong(key, PlanTexts.text("wrongType", key, shown(found), expected));
      return Optional.empty();
    }
    return Optional.of(type.cast(found));
  }

  static String shown(Object found) {
    return switch (found) {
      case String text -> '"' + text + '"';
      case TomlTable _ -> PlanTexts.text("aTable");
      case TomlArray _ -> PlanTexts.text("anArray");
      default -> found.toString();
    };
  }

  Optional<String> text(String key, String expected) {
    Optional<String> found = value(key, String.class, expected);
    if (found.filter(String::isBlank).isPresent()) {
      wrong(key, PlanTexts.text("emptyText", key, expected));
      return Optional.empty();
    }
    return found;
  }

  boolean flag(String key, boolean otherwise) {
    return value(key, Boolean.class, PlanTexts.text("trueOrFalse")).orElse(otherwise);
  }

  /** A number, whole or not. */
  OptionalDouble number(String key, double least, double most, String unit) {
    Optional<Number> found = value(key, Number.class, PlanTexts.text("aNumber"));
    if (found.isEmpty()) {
      return OptionalDouble.empty();
    }
    double number = found.get().doubleValue();
    if (!(number >= least && number <= most)) {
      wrong(key, PlanTexts.text("numberOutside", key, found.get() + unit, least, most + unit));
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(number);
  }

  OptionalLong whole(String key, long least, long most) {
    Optional<Long> found = value(key, Long.class, PlanTexts.text("aWholeNumber"));
    if (found.isPresent() && (found.get() < least || found.get() > most)) {
      wrong(key, PlanTexts.text("numberOutside", key, found.get(), least, most));
      return OptionalLong.empty();
    }
    return found.isPresent() ? OptionalLong.of(found.get()) : OptionalLong.empty();
  }

  /** The elements of an array; none where there is none. */
  List<Object> array(String key, int most, String expected) {
    Optional<TomlArray> found = value(key, TomlArray.class, expected);
    if (found.isPresent() && found.get().size() > most) {
      wrong(key, PlanTexts.text("tooManyElements", key, found.get().size(), most));
      return List.of();
    }
    return found.map(TomlArray::toList).orElse(List.of());
  }

  List<String> texts(String key, int most, String expected) {
    List<String> texts = new ArrayList<>();
    for (Object each : array(key, most, expected)) {
      if (each instanceof String text) {
        texts.add(text);
      } else {
        wrong(key, PlanTexts.text("wrongElement", key, shown(each), expected));
      }
    }
    return texts;
  }

  /** The table under a key. */
  Optional<TomlFields> fields(String key) {
    return value(key, TomlTable.class, PlanTexts.text("aTableOf", key))
        .map(
            found ->
                new TomlFields(
                    file, found, "[" + key + "]", table.inputPositionOf(List.of(key)), mistakes));
  }

  /** The tables under a key, which may be there several times. */
  List<TomlFields> allFields(String key, int most) {
    List<TomlFields> all = new ArrayList<>();
    Optional<TomlArray> found = value(key, TomlArray.class, PlanTexts.text("tablesOf", key));
    if (found.isPresent() && found.get().size() > most) {
      wrong(key, PlanTexts.text("tooManyTables", found.get().size(), key, most));
      return all;
    }
    TomlArray array = found.orElse(null);
    for (int i = 0; array != null && i < array.size(); i++) {
      if (array.get(i) instanceof TomlTable each) {
        all.add(new TomlFields(file, each, "[[" + key + "]]", array.inputPositionOf(i), mistakes));
      } else {
        wrong(key, PlanTexts.text("noTables", key, key));
      }
    }
    return all;
  }
}
