package org.pendant.command.rpc;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.pendant.language.check.Nearest;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;
import org.pendant.models.json.Range;

/** RPC parameters: those of one request, asked for by name as what they must be. */
final class RpcParams {
  /** Numbers that a controller counts with. */
  private static final long MAX_WHOLE = 1L << 53;

  private final Json.Members members;
  private final JsonFields fields;

  private RpcParams(Json.Members members) throws JsonException {
    this.members = members;
    fields = new JsonFields(members, "params");
  }

  /** The parameters of a request. */
  static RpcParams of(Json params) throws RpcFailure {
    if (!(params instanceof Json.Members members)) {
      throw RpcFailure.params(RpcTexts.text("wrongParams", params.described()));
    }
    try {
      return new RpcParams(members);
    } catch (JsonException e) {
      throw RpcFailure.of(RpcFailure.INVALID_PARAMS, e);
    }
  }

  /** Refuses all others than these and {@code handle}. */
  void allow(String... keys) throws RpcFailure {
    List<String> all = new ArrayList<>(List.of(keys));
    all.add(Robots.HANDLE);
    try {
      fields.allow(Nearest::among, all.toArray(String[]::new));
    } catch (JsonException e) {
      throw RpcFailure.of(RpcFailure.INVALID_PARAMS, e);
    }
  }

  boolean has(String key) {
    return members.byKey().containsKey(key);
  }

  /** All of them, by name. */
  Map<String, Json.Member> all() {
    return members.byKey();
  }

  Optional<Json> get(String key) {
    return fields.optional(key);
  }

  Optional<String> text(String key) throws RpcFailure {
    Optional<Json> value = get(key);
    return value.isPresent() ? Optional.of(text(key, value.get())) : Optional.empty();
  }

  private static String text(String key, Json value) throws RpcFailure {
    if (value instanceof Json.Text text) {
      return text.value();
    }
    throw wrong(key, value, RpcTexts.text("aText"));
  }

  /** A list of texts; empty if it is left out. */
  Optional<List<String>> texts(String key) throws RpcFailure {
    Optional<Json> value = get(key);
    if (value.isEmpty()) {
      return Optional.empty();
    }
    if (!(value.get() instanceof Json.Elements array)) {
      throw wrong(key, value.get(), RpcTexts.text("arrayOfTexts"));
    }
    List<String> texts = new ArrayList<>();
    for (Json each : array.values()) {
      texts.add(text(key, each));
    }
    return Optional.of(texts);
  }

  OptionalDouble number(String key, Range range) throws RpcFailure {
    Optional<Json> value = get(key);
    if (value.isEmpty()) {
      return OptionalDouble.empty();
    }
    return OptionalDouble.of(number(key, value.get(), range));
  }

  /** The number that {@code value} must be. */
  static double number(String key, Json value, Range range) throws RpcFailure {
    try {
      return JsonFields.number(key, value, range);
    } catch (JsonException e) {
      throw RpcFailure.of(RpcFailure.INVALID_PARAMS, e);
    }
  }

  OptionalLong whole(String key, long least, long most) throws RpcFailure {
    OptionalDouble number =
        number(key, new Range((double) least, (double) Math.min(most, MAX_WHOLE), ""));
    if (number.isEmpty()) {
      return OptionalLong.empty();
    }
    if (number.getAsDouble() != Math.rint(number.getAsDouble())) {
      throw RpcFailure.params(RpcTexts.text("wholeNumber", key, number.getAsDouble()));
    }
    return OptionalLong.of((long) number.getAsDouble());
  }

  Optional<Boolean> flag(String key) throws RpcFailure {
    Optional<Json> value = get(key);
    return value.isPresent() ? Optional.of(level(key, value.get())) : Optional.empty();
  }

  /** The truth that {@code value} must be. */
  static boolean level(String key, Json value) throws RpcFailure {
    if (value instanceof Json.Word word && !word.word().equals("null")) {
      return word.word().equals("true");
    }
    throw wrong(key, value, RpcTexts.text("trueOrFalse"));
  }

  /** The members of an object that must be there. */
  static Map<String, Json.Member> members(String key, Json value) throws RpcFailure {
    if (value instanceof Json.Members object) {
      return object.byKey();
    }
    throw wrong(key, value, RpcTexts.text("anObject"));
  }

  /** The complaint that a parameter is not there. */
  static RpcFailure missing(String key) {
    return RpcFailure.params(RpcTexts.text("missing", key));
  }

  /** The complaint that {@code value} is not of the right kind. */
  static RpcFailure wrong(String key, Json value, String expected) {
    return RpcFailure.of(RpcFailure.INVALID_PARAMS, JsonFields.wrong(key, value, expected));
  }
}
