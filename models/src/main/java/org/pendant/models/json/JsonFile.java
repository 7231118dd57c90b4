package org.pendant.models.json;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.CharBuffer;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.core.exc.UnexpectedEndOfInputException;
import tools.jackson.core.json.JsonFactory;

/**
 * Reader of one JSON value from a file of UTF-8, with the place of everything in it. The streaming
 * parser alone is used: it tells the places, and data binding would cost each start of the program
 * more than the whole file is worth.
 */
public final class JsonFile {
  /** Far above what anybody writes by hand; a larger file is a mistake. */
  static final int MAX_BYTES = 1 << 20;

  /** Objects and arrays within one another at most: twice what any file needs. */
  static final int DEEPEST = 8;

  /** What the parser's messages say about the parser itself. */
  private static final String PARSER_TALK =
      ": (enable|hexa).*|:? \\((start marker|for |not recognized|consider).*|, from `[^`]*`";

  /** Values in a large file at most: each takes far more memory than letters of the file. */
  private static final int MAX_VALUES = 1 << 19;

  private final String file;
  private final int maxBytes;
  private final int deepest;
  private int values;

  private JsonFile(String file, int maxBytes, int deepest) {
    this.file = file;
    this.maxBytes = maxBytes;
    this.deepest = deepest;
  }

  /**
   * Reads all of {@code in}.
   *
   * @throws JsonException if that fails, or it is not one JSON value
   */
  public static Json read(String file, InputStream in) throws JsonException {
    return read(file, in, MAX_BYTES, DEEPEST);
  }

  /**
   * Reads all of a file of another program, which may be larger.
   *
   * @param maxBytes what it may have
   * @param deepest objects and arrays within one another at most
   * @throws JsonException if that fails, or it is not one JSON value
   */
  public static Json read(String file, InputStream in, int maxBytes, int deepest)
      throws JsonException {
    return new JsonFile(file, maxBytes, deepest).read(in);
  }

  /**
   * Reads a file of the program.
   *
   * @param owner a class of the package that the file lies in
   * @param file its path from there, such as {@code ur5e.json}
   * @throws IllegalStateException if the file is missing from the build
   * @throws JsonException if it is not one JSON value
   */
  public static Json ofResource(Class<?> owner, String file) throws JsonException {
    try (InputStream in = owner.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException(file + " is missing from this build");
      }
      return read(file, in);
    } catch (IOException e) {
      throw new UncheckedIOException(file + " cannot be read", e);
    }
  }

  private Json read(InputStream in) throws JsonException {
    String text = text(bytes(in));
    try (JsonParser parser = new JsonFactory().createParser(ObjectReadContext.empty(), text)) {
      try {
        if (parser.nextToken() == null) {
          throw place(parser.currentLocation()).refusal(JsonTexts.text("fileEmpty"));
        }
        Json value = value(parser, 1);
        if (parser.nextToken() != null) {
          throw here(parser).refusal(JsonTexts.text("moreText"));
        }
        return value;
      } catch (JacksonException e) {
        TokenStreamLocation at = e.getLocation();
        throw place(at == null ? parser.currentLocation() : at).refusal(complaint(e));
      }
    }
  }

  private byte[] bytes(InputStream in) throws JsonException {
    try {
      // what a device or a pipe says of its size is worth nothing, so the reading itself is bounded
      byte[] bytes = in.readNBytes(maxBytes + 1);
      if (bytes.length > maxBytes) {
        throw new JsonException(JsonTexts.text("fileTooLong", file, maxBytes));
      }
      return bytes;
    } catch (IOException e) {
      throw new JsonException(JsonTexts.text("unreadable", file, e.getMessage()));
    }
  }

  /** The letters of the file, so that columns count letters; without the mark some editors set. */
  private String text(byte[] bytes) throws JsonException {
    CharBuffer letters = CharBuffer.allocate(bytes.length);
    boolean wrong =
        StandardCharsets.UTF_8
            .newDecoder()
            .onMalformedInput(CodingErrorAction.REPORT)
            .decode(ByteBuffer.wrap(bytes), letters, true)
            .isError();
    String text = letters.flip().toString();
    if (wrong) {
      throw FilePosition.after(file, text).refusal(JsonTexts.text("notUtf8"));
    }
    return text.startsWith("\ufeff") ? text.substring(1) : text;
  }

  private Json value(JsonParser parser, int depth) throws JsonException {
    FilePosition place = here(parser);
    if (depth > deepest) {
      throw place.refusal(JsonTexts.text("tooDeep", deepest));
    }
    if (++values > MAX_VALUES) {
      throw place.refusal(JsonTexts.text("tooManyValues", MAX_VALUES));
    }
    return switch (parser.currentToken()) {
      case START_OBJECT -> members(parser, depth, place);
      case START_ARRAY -> {
        List<Json> values = new ArrayList<>();
        while (parser.nextToken() != JsonToken.END_ARRAY) {
          values.add(value(parser, depth + 1));
        }
        yield new Json.Elements(values, place);
      }
      case VALUE_STRING -> new Json.Text(parser.getString(), place);
      case VALUE_NUMBER_INT, VALUE_NUMBER_FLOAT ->
          // not getDoubleValue: loading the fast number parser behind it takes longer than a file
          new Json.Numeral(Double.parseDouble(parser.getString()), place);
      case VALUE_TRUE, VALUE_FALSE, VALUE_NULL -> new Json.Word(parser.getString(), place);
      case NOT_AVAILABLE, END_OBJECT, END_ARRAY, PROPERTY_NAME, VALUE_EMBEDDED_OBJECT ->
          throw new IllegalStateException(parser.currentToken() + " where a value begins");
    };
  }

  private Json members(JsonParser parser, int depth, FilePosition place) throws JsonException {
    Map<String, Json.Member> members = new LinkedHashMap<>();
    while (parser.nextToken() != JsonToken.END_OBJECT) {
      String key = parser.currentName();
      FilePosition keyPlace = here(parser);
      if (members.containsKey(key)) {
        throw keyPlace.refusal(JsonTexts.text("keyAgain", Json.quoted(key)));
      }
      parser.nextToken();
      members.put(key, new Json.Member(value(parser, depth + 1), keyPlace));
    }
    return new Json.Members(members, place);
  }

  private FilePosition here(JsonParser parser) {
    return place(parser.currentTokenLocation());
  }

  private FilePosition place(TokenStreamLocation location) {
    return new FilePosition(file, location.getLineNr(), location.getColumnNr());
  }

  private static String complaint(JacksonException e) {
    return e instanceof UnexpectedEndOfInputException
        ? JsonTexts.text("endsTooEarly")
        : JsonTexts.text(
            "notJson",
            Pattern.compile(PARSER_TALK).matcher(e.getOriginalMessage()).replaceFirst(""));
  }
}
