package org.pendant.protocols.robotapi;

import java.io.StringWriter;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;

/** JSON writer: an object of JSON, made member after member. */
final class JsonText {
  private final List<Consumer<JsonGenerator>> members = new ArrayList<>();

  /** Adds a text. */
  JsonText with(String key, String value) {
    members.add(out -> out.writeStringProperty(key, value));
    return this;
  }

  /** Adds a number. */
  JsonText with(String key, long value) {
    members.add(out -> out.writeNumberProperty(key, value));
    return this;
  }

  /** Adds an object. */
  JsonText with(String key, JsonText value) {
    members.add(
        out -> {
          out.writeName(key);
          value.write(out);
        });
    return this;
  }

  /** Adds an array of objects. */
  JsonText with(String key, List<JsonText> values) {
    members.add(
        out -> {
          out.writeArrayPropertyStart(key);
          values.forEach(each -> each.write(out));
          out.writeEndArray();
        });
    return this;
  }

  private void write(JsonGenerator out) {
    out.writeStartObject();
    members.forEach(each -> each.accept(out));
    out.writeEndObject();
  }

  /** The object as it is now. */
  String text() {
    StringWriter text = new StringWriter();
    try (JsonGenerator out = new JsonFactory().createGenerator(ObjectWriteContext.empty(), text)) {
      write(out);
    }
    return text.toString();
  }
}
