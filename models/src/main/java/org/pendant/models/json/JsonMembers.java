package org.pendant.models.json;

import java.util.LinkedHashMap;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/** JSON members: those of an object as its text says them, for who writes it anew. */
public final class JsonMembers {
  private JsonMembers() {}

  /**
   * The members of an object in their order, each as JSON: objects and arrays with their own text.
   *
   * @param text one JSON object
   * @throws IllegalArgumentException if it is none
   */
  public static Map<String, String> of(String text) {
    Map<String, String> members = new LinkedHashMap<>();
    try (JsonParser parser = new JsonFactory().createParser(ObjectReadContext.empty(), text)) {
      if (parser.nextToken() != JsonToken.START_OBJECT) {
        throw new IllegalArgumentException("the text is no object");
      }
      while (parser.nextToken() != JsonToken.END_OBJECT) {
        String key = parser.currentName();
        JsonToken value = parser.nextToken();
        if (value.isStructStart()) {
          int start = (int) parser.currentTokenLocation().getCharOffset();
          parser.skipChildren();
          members.put(key, text.substring(start, (int) parser.currentLocation().getCharOffset()));
        } else {
          String word = parser.getString();
          members.put(key, value == JsonToken.VALUE_STRING ? JsonValues.text(word) : word);
        }
      }
    } catch (JacksonException e) {
      throw new IllegalArgumentException(e.getOriginalMessage(), e);
    }
    return members;
  }
}
