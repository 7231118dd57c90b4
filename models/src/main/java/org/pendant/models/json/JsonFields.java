package org.pendant.models.json;

import java.util.List;
import java.util.Optional;
import org.pendant.language.check.Nearest;

/** The members of one JSON object, asked for by key; every complaint says where. */
public final class JsonFields {
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
      throw value.place().refusal(what + " is " + value.described() + ", must be an object");
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
   * @throws JsonException for the first one in the file
   */
  public void allow(String... keys) throws JsonException {
    List<String> known = List.of(keys);
    for (var member : members.byKey().entrySet()) {
      String key = member.getKey();
      if (!known.contains(key)) {
        String hint =
            new Nearest().to(key, () -> known).map(n -> "did you mean " + n + "? ").orElse("");
        throw member
            .getValue()
            .keyPlace()
            .refusal(
                "unknown key "
                    + Json.quoted(key)
                    + ", "
                    + hint
                    + what
                    + " may have "
                    + String.join(", ", known));
      }
    }
  }

  /** The value of a key that may be left out. */
  public Optional<Json> optional(String key) {
    return Optional.ofNullable(members.byKey().get(key)).map(Json.Member::value);
  }

  /** The value of a key that must be there. */
  public Json required(String key) throws JsonException {
    Json.Member member = members.byKey().get(key);
    if (member == null) {
      throw place().refusal("key \"" + key + "\" is missing, " + what + " must have it");
    }
    return member.value();
  }

  /** A text that must be there. */
  public Json.Text text(String key) throws JsonException {
    Json value = required(key);
    if (value instanceof Json.Text text) {
      return text;
    }
    throw wrong(key, value, "a text");
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
    throw wrong(key, value, "an array of " + count + " numbers");
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
    throw wrong(key, value.get(), "an array of at most " + most);
  }

  /** The number that {@code value} must be. */
  public static double number(String name, Json value, Range range) throws JsonException {
    if (!(value instanceof Json.Numeral number)) {
      throw wrong(name, value, "a number");
    }
    if (!range.holds(number.value())) {
      throw number.place().refusal(range.refusal(name, number.value()));
    }
    return number.value();
  }

  /** The complaint that {@code value} is not of the right kind. */
  public static JsonException wrong(String name, Json value, String expected) {
    return value.place().refusal(name + " is " + value.described() + ", must be " + expected);
  }
}
