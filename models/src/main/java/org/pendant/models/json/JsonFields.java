package org.pendant.models.json;

import static org.pendant.models.json.JsonTexts.text;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;

/**
 * Members of one JSON object, asked for by key as the type that they must have; every refusal says
 * where.
 *
 * <p>Every start of the program reads an arm description through here: no code made at run time
 * (lambdas, text joined by plus) where nothing is wrong.
 */
public final class JsonFields {
  /** Spelling help for keys that are not known. */
  @FunctionalInterface
  public interface Spelling {
    /** The candidate that was probably meant by {@code name}, if one is near. */
    Optional<String> nearest(String name, Collection<String> candidates);
  }

  private final Json.Members members;
  private final String what;

  /**
   * The members of {@code value}.
   *
   * @param what it should be, for messages: "a sphere"
   * @throws JsonException if the value is no object
   */
  public JsonFields(Json value, String what) throws JsonException {
    if (!(value instanceof Json.Members object)) {
      throw value.place().refusal(JsonTexts.text("noObject", what, value.described()));
    }
    this.members = object;
    this.what = what;
  }

  /** Where the object begins. */
  public FilePosition place() {
    return members.place();
  }

  /**
   * Refuses every key that is not listed.
   *
   * @param spelling finds the listed key that was probably meant
   * @throws JsonException for the first one in the file
   */
  public void allow(Spelling spelling, String... keys) throws JsonException {
    List<String> known = List.of(keys);
    for (var member : members.byKey().entrySet()) {
      String key = member.getKey();
      if (!known.contains(key)) {
        String quoted = Json.quoted(key);
        String legal = String.join(", ", known);
        throw member
            .getValue()
            .keyPlace()
            .refusal(
                spelling
                    .nearest(key, known)
                    .map(near -> JsonTexts.text("unknownKeyDidYouMean", quoted, near, what, legal))
                    .orElseGet(() -> JsonTexts.text("unknownKey", quoted, what, legal)));
      }
    }
  }

  /** The value of a key that may be left out. */
  public Optional<Json> optional(String key) {
    Json.Member member = members.byKey().get(key);
    return member == null ? Optional.empty() : Optional.of(member.value());
  }

  /** The value of a key that must be there. */
  public Json required(String key) throws JsonException {
    Json.Member member = members.byKey().get(key);
    if (member == null) {
      throw place().refusal(JsonTexts.text("keyMissing", key, what));
    }
    return member.value();
  }

  /** A text that must be there. */
  public Json.Text text(String key) throws JsonException {
    Json value = required(key);
    if (value instanceof Json.Text text) {
      return text;
    }
    throw wrong(key, value, JsonTexts.text("aText"));
  }

  /** Whether a key is there and true. */
  public boolean flag(String key) throws JsonException {
    Json.Member member = members.byKey().get(key);
    if (member == null) {
      return false;
    }
    if (member.value() instanceof Json.Word word && !word.word().equals("null")) {
      return word.word().equals("true");
    }
    throw wrong(key, member.value(), JsonTexts.text("trueOrFalse"));
  }

  /** An object that must be there; messages call it by its key. */
  public JsonFields object(String key) throws JsonException {
    return new JsonFields(required(key), key);
  }

  /** The objects of an array that must be there; messages call each by the key. */
  public List<JsonFields> objects(String key) throws JsonException {
    List<JsonFields> objects = new ArrayList<>();
    for (Json each : elements(key, "objectArray")) {
      objects.add(new JsonFields(each, key));
    }
    return objects;
  }

  /** The texts of an array that must be there. */
  public List<String> texts(String key) throws JsonException {
    List<String> texts = new ArrayList<>();
    for (Json each : elements(key, "textArray")) {
      if (!(each instanceof Json.Text text)) {
        throw wrong(key, each, JsonTexts.text("aText"));
      }
      texts.add(text.value());
    }
    return texts;
  }

  private List<Json> elements(String key, String expectedKey) throws JsonException {
    Json value = required(key);
    if (value instanceof Json.Elements array) {
      return array.values();
    }
    throw wrong(key, value, JsonTexts.text(expectedKey));
  }

  /** A number of any size that must be there. */
  public double number(String key) throws JsonException {
    return numeral(key, required(key)).value();
  }

  /** An array of {@code count} numbers of any size that must be there. */
  public double[] vector(String key, int count) throws JsonException {
    List<Json> values = numbers(key, count);
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      numbers[i] = numeral(key, values.get(i)).value();
    }
    return numbers;
  }

  /** A number that must be there. */
  public double number(String key, Range range) throws JsonException {
    return number(key, required(key), range);
  }

  /** A number, or {@code otherwise} if it is left out. */
  public double number(String key, Range range, double otherwise) throws JsonException {
    Optional<Json> value = optional(key);
    return value.isPresent() ? number(key, value.get(), range) : otherwise;
  }

  /** An array of {@code count} values that must be there, numbers by right. */
  public List<Json> numbers(String key, int count) throws JsonException {
    Json value = required(key);
    if (value instanceof Json.Elements array && array.values().size() == count) {
      return array.values();
    }
    throw wrong(key, value, JsonTexts.text("numberArray", count));
  }

  /** The values of an array that may be left out, which is like an empty one. */
  public List<Json> array(String key, int most) throws JsonException {
    Optional<Json> value = optional(key);
    if (value.isEmpty()) {
      return List.of();
    }
    if (value.get() instanceof Json.Elements array && array.values().size() <= most) {
      return array.values();
    }
    throw wrong(key, value.get(), JsonTexts.text("shortArray", most));
  }

  /** The number that {@code value} must be. */
  public static double number(String name, Json value, Range range) throws JsonException {
    Json.Numeral number = numeral(name, value);
    if (!range.holds(number.value())) {
      throw number.place().refusal(range.refusal(name, number.value()));
    }
    return number.value();
  }

  private static Json.Numeral numeral(String name, Json value) throws JsonException {
    if (value instanceof Json.Numeral number) {
      return number;
    }
    throw wrong(name, value, JsonTexts.text("aNumber"));
  }

  /** The complaint that {@code value} is not of the right kind. */
  public static JsonException wrong(String name, Json value, String expected) {
    return value.place().refusal(JsonTexts.text("wrongKind", name, value.described(), expected));
  }
}
