package org.pendant.protocols.robotapi;

import java.util.List;

/** Writes an object of JSON (RFC 8259), member after member. */
final class JsonText {
  private final StringBuilder text = new StringBuilder("{");

  /** Adds a text. */
  JsonText with(String key, String value) {
    begin(key);
    quote(value);
    return this;
  }

  /** Adds a number. */
  JsonText with(String key, long value) {
    begin(key);
    text.append(value);
    return this;
  }

  /** Adds an object. */
  JsonText with(String key, JsonText value) {
    begin(key);
    text.append(value.text());
    return this;
  }

  /** Adds an array of objects. */
  JsonText with(String key, List<JsonText> values) {
    begin(key);
    text.append('[');
    for (int i = 0; i < values.size(); i++) {
      text.append(i == 0 ? "" : ",").append(values.get(i).text());
    }
    text.append(']');
    return this;
  }

  private void begin(String key) {
    if (text.length() > 1) {
      text.append(',');
    }
    quote(key);
    text.append(':');
  }

  private void quote(String value) {
    text.append('"');
    for (int i = 0; i < value.length(); i++) {
      char letter = value.charAt(i);
      if (letter == '"' || letter == '\\') {
        text.append('\\').append(letter);
      } else if (letter < ' ') {
        text.append("\\u00").append(letter < 0x10 ? '0' : '1');
        text.append(Character.forDigit(letter & 0xF, 16));
      } else {
        text.append(letter);
      }
    }
    text.append('"');
  }

  /** The object as it is now. */
  String text() {
    return text + "}";
  }
}
