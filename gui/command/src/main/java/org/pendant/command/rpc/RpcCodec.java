package org.pendant.command.rpc;

import java.io.ByteArrayInputStream;
import java.io.StringWriter;
import java.nio.ByteBuffer;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.models.json.Json;
import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFile;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonWriteFeature;

/**
 * Codec of JSON-RPC 2.0: requests from lines, and lines of ASCII with answers. Values in answers
 * are maps, collections, texts, numbers, booleans, and {@link Optional} for what may be null;
 * numbers that JSON cannot say are null.
 */
final class RpcCodec {
  /** What messages call a line; {@link RpcFailure} takes it away again. */
  static final String FILE = "request";

  private static final JsonFactory JSON =
      JsonFactory.builder().enable(JsonWriteFeature.ESCAPE_NON_ASCII).build();

  /** The largest whole number that a double holds for sure. */
  private static final double MAX_WHOLE = 1L << 53;

  private RpcCodec() {}

  /** The JSON value in a line. */
  static Json read(ByteBuffer line) throws RpcFailure {
    byte[] bytes = new byte[line.remaining()];
    line.duplicate().get(bytes);
    try {
      return JsonFile.read(FILE, new ByteArrayInputStream(bytes));
    } catch (JsonException e) {
      throw RpcFailure.of(RpcFailure.PARSE_ERROR, e);
    }
  }

  /** The id of a request, to be repeated in the answer. */
  static Object id(Json id) throws RpcFailure {
    return switch (id) {
      case Json.Text text -> text.value();
      case Json.Numeral number
          when number.value() == Math.rint(number.value())
              && Math.abs(number.value()) <= MAX_WHOLE ->
          (long) number.value();
      case Json.Word word when word.word().equals("null") -> Optional.empty();
      case Json.Numeral _, Json.Word _, Json.Elements _, Json.Members _ ->
          throw new RpcFailure(
              RpcFailure.INVALID_REQUEST, RpcTexts.text("wrongId", id.described()));
    };
  }

  /** The answer to a request that has been carried out. */
  static Map<String, Object> result(Object id, Object result) {
    Map<String, Object> answer = begin(id);
    answer.put("result", result);
    return answer;
  }

  /** The answer to one that has not. */
  static Map<String, Object> error(Object id, RpcFailure failure) {
    Map<String, Object> error = new LinkedHashMap<>();
    error.put("code", failure.code());
    error.put("message", failure.getMessage());
    if (!failure.data().isEmpty()) {
      error.put("data", failure.data());
    }
    Map<String, Object> answer = begin(id);
    answer.put("error", error);
    return answer;
  }

  private static Map<String, Object> begin(Object id) {
    Map<String, Object> answer = new LinkedHashMap<>();
    answer.put("jsonrpc", "2.0");
    answer.put("id", id);
    return answer;
  }

  /** The text of a value, in one line. */
  static String text(Object value) {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = JSON.createGenerator(ObjectWriteContext.empty(), text)) {
      write(out, value);
    }
    return text.toString();
  }

  private static void write(JsonGenerator out, Object value) {
    switch (value) {
      case Map<?, ?> members -> {
        out.writeStartObject();
        members.forEach(
            (name, each) -> {
              out.writeName(name.toString());
              write(out, each);
            });
        out.writeEndObject();
      }
      case Collection<?> items -> {
        out.writeStartArray();
        items.forEach(each -> write(out, each));
        out.writeEndArray();
      }
      case Optional<?> perhaps -> {
        if (perhaps.isPresent()) {
          write(out, perhaps.get());
        } else {
          out.writeNull();
        }
      }
      case Double number when Double.isFinite(number) -> out.writeNumber(number);
      case Double _ -> out.writeNull();
      case Long number -> out.writeNumber(number);
      case Integer number -> out.writeNumber(number);
      case Boolean truth -> out.writeBoolean(truth);
      case String text -> out.writeString(text);
      default -> throw new IllegalArgumentException(value.getClass() + " is no value of an answer");
    }
  }
}
