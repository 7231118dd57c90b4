package org.pendant.models.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class JsonObjectTest {
  private static final String ALL =
      """
      {
        "name": "elbow", "mass": 1.5, "on": true, "off": false,
        "com": [1, -2e-3, 0], "notes": ["a", "b"],
        "inner": {"mass": 2}, "parts": [{"name": "x"}, {"name": "y"}]
      }
      """;

  private static JsonObject parse(String json) {
    return JsonObject.parse(
        "test.json", new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)));
  }

  private static String refusal(Executable action) {
    return assertThrows(IllegalStateException.class, action).getMessage();
  }

  @Test
  void membersAreReadAsTheirTypes() {
    JsonObject root = parse(ALL);

    assertEquals("elbow", root.text("name"));
    assertEquals(1.5, root.number("mass"));
    assertTrue(root.flag("on"));
    assertFalse(root.flag("off"));
    assertFalse(root.flag("absent"));
    assertArrayEquals(new double[] {1, -0.002, 0}, root.numbers("com", 3));
    assertEquals(List.of("a", "b"), root.texts("notes"));
    assertEquals(2, root.object("inner").number("mass"));
    assertEquals("y", root.objects("parts").get(1).text("name"));
  }

  @Test
  void membersOfAnotherTypeAreRefused() {
    JsonObject root = parse(ALL);

    assertEquals("test.json: mass is 1.5, must be a text", refusal(() -> root.text("mass")));
    assertEquals("test.json: name is elbow, must be a number", refusal(() -> root.number("name")));
    assertEquals("test.json: mass is 1.5, must be true or false", refusal(() -> root.flag("mass")));
    assertEquals("test.json: mass is 1.5, must be an object", refusal(() -> root.object("mass")));
    assertEquals(
        "test.json: inner is {mass=2.0}, must be an array of objects",
        refusal(() -> root.objects("inner")));
    assertEquals(
        "test.json: notes is [a, b], must be an array of objects",
        refusal(() -> root.objects("notes")));
    assertEquals(
        "test.json: com is [1.0, -0.002, 0.0], must be an array of texts",
        refusal(() -> root.texts("com")));
    assertEquals(
        "test.json: com is [1.0, -0.002, 0.0], must be 6 numbers",
        refusal(() -> root.numbers("com", 6)));
    assertEquals(
        "test.json: notes is [a, b], must be 2 numbers", refusal(() -> root.numbers("notes", 2)));
  }

  @Test
  void missingMembersAreRefused() {
    assertEquals(
        "test.json: mass is missing, must be a number", refusal(() -> parse("{}").number("mass")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"nonsense", "", "{\"a\": [", "{\"a\": null}", "[1]", "1"})
  void whatIsNoObjectIsRefusedWithTheNameOfTheFile(String json) {
    String message = refusal(() -> parse(json));
    assertTrue(message.startsWith("test.json: "), message);
  }

  @Test
  void aMissingFileIsNamed() {
    assertEquals(
        "nothing.json is missing from this build",
        refusal(() -> JsonObject.ofResource(JsonObject.class, "nothing.json")));
  }

  @Test
  void refusalsOfOthersGetTheNameOfTheFileAndKeepTheirCause() {
    IllegalArgumentException reason = new IllegalArgumentException("mass is -1 kg");
    IllegalStateException refused = parse("{}").refused(reason);

    assertEquals("test.json: mass is -1 kg", refused.getMessage());
    assertSame(reason, refused.getCause());
  }
}
