package org.pendant.models.json;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.json.JsonFactory;

/**
 * An object of a JSON file: members by name, each asked for as the type it must have. A member that
 * is missing or has another type is an {@link IllegalStateException} that names the file.
 *
 * <p>The streaming parser alone is used: data binding would cost each start of the program more
 * than the whole file is worth. For the same reason nothing here that runs on every start needs
 * code made at run time (lambdas, text joined by plus).
 */
public final class JsonObject {
  private final String file;
  private final Map<String, Object> members;

  private JsonObject(String file, Map<String, Object> members) {
    this.file = file;
    this.members = members;
  }

  /**
   * Reads a file of the program.
   *
   * @param owner a class of the package that the file lies in
   * @param file its path from there, such as {@code ur5e.json}
   * @throws IllegalStateException if the file is missing, or not one JSON object
   */
  public static JsonObject ofResource(Class<?> owner, String file) {
    try (InputStream in = owner.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException(file + " is missing from this build");
      }
      return parse(file, in);
    } catch (IOException e) {
      throw new UncheckedIOException(file + " cannot be read", e);
    }
  }

  /**
   * Reads JSON text.
   *
   * @param file what error messages call it
   * @param in UTF-8; the caller closes it
   * @throws IllegalStateException if it is not one JSON object
   */
  public static JsonObject parse(String file, InputStream in) {
    JsonFactory factory = new JsonFactory();
    try (JsonParser parser = factory.createParser(ObjectReadContext.empty(), in)) {
      parser.nextToken();
      Object root = value(file, parser);
      if (root instanceof JsonObject object) {
        return object;
      }
      throw wrong(file, "the file", root, "an object");
    } catch (JacksonException e) {
      throw new IllegalStateException(file + ": " + e.getMessage(), e);
    }
  }

  private static Object value(String file, JsonParser parser) {
    JsonToken token = parser.currentToken();
    if (token == null) {
      throw new IllegalStateException(file + ": ends where a value must be");
    }
    return switch (token) {
      case START_OBJECT -> {
        Map<String, Object> members = new LinkedHashMap<>();
        while (parser.nextToken() != JsonToken.END_OBJECT) {
          String name = parser.currentName();
          parser.nextToken();
          members.put(name, value(file, parser));
        }
        yield new JsonObject(file, members);
      }
      case START_ARRAY -> {
        List<Object> elements = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          elements.add(value(file, parser));
        }
        yield elements;
      }
      case VALUE_STRING -> parser.getString();
      // not getDoubleValue: loading the fast number parser behind it takes longer than the file
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT -> Double.valueOf(parser.getString());
      case VALUE_TRUE -> true;
      case VALUE_FALSE -> false;
      default ->
          throw new IllegalStateException(
              file + ": " + token + " is not an object, array, text, number or truth value");
    };
  }

  /** The text called {@code name}. */
  public String text(String name) {
    if (members.get(name) instanceof String text) {
      return text;
    }
    throw wrong(name, "a text");
  }

  /** The number called {@code name}. */
  public double number(String name) {
    if (members.get(name) instanceof Double number) {
      return number;
    }
    throw wrong(name, "a number");
  }

  /** Whether {@code name} is there and true. */
  public boolean flag(String name) {
    Object value = members.get(name);
    if (value == null) {
      return false;
    }
    if (value instanceof Boolean flag) {
      return flag;
    }
    throw wrong(name, "true or false");
  }

  /** The object called {@code name}. */
  public JsonObject object(String name) {
    if (members.get(name) instanceof JsonObject object) {
      return object;
    }
    throw wrong(name, "an object");
  }

  /** The objects of the array called {@code name}. */
  public List<JsonObject> objects(String name) {
    List<JsonObject> objects = new ArrayList<>();
    for (Object element : array(name, "an array of objects")) {
      if (!(element instanceof JsonObject object)) {
        throw wrong(name, "an array of objects");
      }
      objects.add(object);
    }
    return objects;
  }

  /** The texts of the array called {@code name}. */
  public List<String> texts(String name) {
    List<String> texts = new ArrayList<>();
    for (Object element : array(name, "an array of texts")) {
      if (!(element instanceof String text)) {
        throw wrong(name, "an array of texts");
      }
      texts.add(text);
    }
    return texts;
  }

  /** The numbers of the array called {@code name}, which must have {@code count} of them. */
  public double[] numbers(String name, int count) {
    List<?> elements = array(name, "an array of numbers");
    if (elements.size() != count) {
      throw wrong(name, count + " numbers");
    }
    double[] numbers = new double[count];
    for (int i = 0; i < count; i++) {
      if (!(elements.get(i) instanceof Double number)) {
        throw wrong(name, count + " numbers");
      }
      numbers[i] = number;
    }
    return numbers;
  }

  private List<?> array(String name, String expected) {
    if (members.get(name) instanceof List<?> elements) {
      return elements;
    }
    throw wrong(name, expected);
  }

  /** The refusal of a value made from this object, with the name of the file before it. */
  public IllegalStateException refused(IllegalArgumentException reason) {
    return new IllegalStateException(file + ": " + reason.getMessage(), reason);
  }

  private IllegalStateException wrong(String name, String expected) {
    return members.containsKey(name)
        ? wrong(file, name, members.get(name), expected)
        : new IllegalStateException(file + ": " + name + " is missing, must be " + expected);
  }

  private static IllegalStateException wrong(
      String file, String name, Object value, String expected) {
    return new IllegalStateException(file + ": " + name + " is " + value + ", must be " + expected);
  }

  /** The members, for error messages. */
  @Override
  public String toString() {
    return members.toString();
  }
}
