package org.pendant.models.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

final class JsonFileTest {
  private static Json read(byte[] bytes) throws JsonException {
    return JsonFile.read("a.json", new ByteArrayInputStream(bytes));
  }

  private static Json read(String text) throws JsonException {
    return read(text.getBytes(StandardCharsets.UTF_8));
  }

  private static String refusal(byte[] bytes) {
    return assertThrows(JsonException.class, () -> read(bytes)).getMessage();
  }

  @Test
  void valuesKnowWhereTheyStand() throws Exception {
    JsonFields fields =
        new JsonFields(read("{\n  \"size\": 1.5,\n  \"name\": \"ball\"\n}"), "a thing");
    assertEquals(new FilePosition("a.json", 2, 11), fields.required("size").place());
    assertEquals(1.5, fields.number("size", new Range(0, 2, "m")));
    assertEquals("ball", fields.text("name").value());
    assertEquals(Optional.empty(), fields.optional("colour"));
    assertEquals(7, fields.number("weight", new Range(0, 9, "kg"), 7));
  }

  @Test
  void columnsCountLettersNotBytes() throws Exception {
    JsonFields fields = new JsonFields(read("{\"\u00e4\": 1, \"b\": 2}"), "a thing");
    assertEquals(new FilePosition("a.json", 1, 15), fields.required("b").place());
  }

  @Test
  void markThatSomeEditorsPutFirstIsPassedOver() throws Exception {
    assertInstanceOf(Json.Members.class, read("\ufeff{}"));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          `` | a.json:1:1: the file is empty, must be an object
          `{} {}` | a.json:1:4: there is more text after the end of the object, must be one object
          `{"a": 1` | a.json:1:8: not JSON: the file ends too early
          `{"a": 1, "a": 2}` | a.json:1:10: key "a" again, must be there once
          `{"a": nix}` | a.json:1:
          `[[[[[[[[[1]]]]]]]]]` | a.json:1:9: more than 8 values within one another
          """)
  void mistakesAreNamedWithTheirPlace(String text, String message) {
    String found = refusal(text.getBytes(StandardCharsets.UTF_8));
    assertTrue(found.startsWith(message), found);
  }

  @Test
  void otherEncodingsAreRefused() {
    assertEquals(
        "a.json:1:3: a byte is no letter, the file must be in UTF-8",
        refusal(new byte[] {'{', '"', (byte) 0xe4, '"', '}'}));
  }

  @Test
  void largeFilesAreRefused() {
    assertEquals(
        "a.json: has more than 1048576 bytes, must be at most that many",
        refusal(new byte[JsonFile.MAX_BYTES + 1]));
  }

  @Test
  void fileThatCannotBeReadIsRefused() {
    InputStream broken =
        new InputStream() {
          @Override
          public int read() throws IOException {
            throw new IOException("the disk is gone");
          }

          @Override
          public int read(byte[] bytes, int offset, int length) throws IOException {
            return read();
          }
        };
    assertEquals(
        "a.json: cannot be read, the disk is gone",
        assertThrows(JsonException.class, () -> JsonFile.read("a.json", broken)).getMessage());
  }
}
