package org.pendant.models.json;

import static org.pendant.models.json.JsonTexts.text;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** A JSON value that knows where it stands. */
public sealed interface Json {
  /** Letters of a text that a message repeats at most. */
  int MAX_QUOTE = 40;

  /** Where it begins. */
  FilePosition place();

  /** What it is, for messages. */
  String described();

  /** An object, its members in the file's order. */
  record Members(Map<String, Member> byKey, FilePosition place) implements Json {
    public Members {
      byKey = Collections.unmodifiableMap(new LinkedHashMap<>(byKey));
    }

    @Override
    public String described() {
      return text("anObject");
    }
  }

  /** A member of an object. */
  record Member(Json value, FilePosition keyPlace) {}

  /** An array. */
  record Elements(List<Json> values, FilePosition place) implements Json {
    public Elements {
      values = List.copyOf(values);
    }

    @Override
    public String described() {
      return text("anArrayOf", values.size());
    }
  }

  /** A string. */
  record Text(String value, FilePosition place) implements Json {
    @Override
    public String described() {
      return quoted(value);
    }
  }

  /** A number; infinite if the file's is too large for a double. */
  record Numeral(double value, FilePosition place) implements Json {
    @Override
    public String described() {
      return Range.number(value);
    }
  }

  /** One of the words {@code true}, {@code false}, {@code null}. */
  record Word(String word, FilePosition place) implements Json {
    @Override
    public String described() {
      return word;
    }
  }

  /** A text for a message: in quotes, not too long, and without line ends. */
  static String quoted(String text) {
    String start = text.length() > MAX_QUOTE ? text.substring(0, MAX_QUOTE) + "..." : text;
    StringBuilder quoted = new StringBuilder("\"");
    for (int i = 0; i < start.length(); i++) {
      char letter = start.charAt(i);
      quoted.append(Character.isISOControl(letter) ? '?' : letter);
    }
    return quoted.append('"').toString();
  }
}
