package org.pendant.models.json;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;

final class JsonFieldsTest {
  private static final String ALL =
      """
      {"name": "elbow", "mass": 1.5, "on": true, "off": false,
       "com": [1, -2e-3, 0], "notes": ["a", "b"],
       "inner": {"mass": 2}, "parts": [{"name": "x"}, {"name": "y"}], "none": null}
      """;

  private static JsonFields parse(String json) throws JsonException {
    byte[] bytes = json.getBytes(StandardCharsets.UTF_8);
    return new JsonFields(JsonFile.read("a.json", new ByteArrayInputStream(bytes)), "a link");
  }

  private static String refusal(Executable action) {
    return assertThrows(JsonException.class, action).getMessage();
  }

  @Test
  void membersAreReadAsTheirTypes() throws Exception {
    JsonFields root = parse(ALL);

    assertEquals("elbow", root.text("name").value());
    assertEquals(1.5, root.number("mass"));
    assertTrue(root.flag("on"));
    assertFalse(root.flag("off"));
    assertFalse(root.flag("absent"));
    assertArrayEquals(new double[] {1, -0.002, 0}, root.vector("com", 3));
    assertEquals(List.of("a", "b"), root.texts("notes"));
    assertEquals(2, root.object("inner").number("mass"));
    assertEquals("y", root.objects("parts").get(1).text("name").value());
  }

  @Test
  void membersOfAnotherTypeAreRefusedWithTheirPlace() throws Exception {
    JsonFields root = parse(ALL);

    assertEquals("a.json:1:27: mass is 1.5, must be a text", refusal(() -> root.text("mass")));
    assertEquals(
        "a.json:1:10: name is \"elbow\", must be a number", refusal(() -> root.number("name")));
    assertEquals(
        "a.json:1:27: mass is 1.5, must be true or false", refusal(() -> root.flag("mass")));
    assertEquals(
        "a.json:3:73: none is null, must be true or false", refusal(() -> root.flag("none")));
    assertEquals("a.json:1:27: mass is 1.5, must be an object", refusal(() -> root.object("mass")));
    assertEquals(
        "a.json:3:11: inner is an object, must be an array of objects",
        refusal(() -> root.objects("inner")));
    assertEquals(
        "a.json:2:34: notes is \"a\", must be an object", refusal(() -> root.objects("notes")));
    assertEquals("a.json:2:10: com is 1, must be a text", refusal(() -> root.texts("com")));
    assertEquals(
        "a.json:2:9: com is an array of 3, must be an array of 6 numbers",
        refusal(() -> root.vector("com", 6)));
    assertEquals(
        "a.json:2:34: notes is \"a\", must be a number", refusal(() -> root.vector("notes", 2)));
  }

  @Test
  void missingMembersAreRefused() {
    assertEquals(
        "a.json:1:1: key \"mass\" is missing, a link must have it",
        refusal(() -> parse("{}").number("mass")));
  }

  @Test
  void whatIsNoObjectIsRefused() {
    assertEquals(
        "a.json:1:1: a link is an array of 1, must be an object", refusal(() -> parse("[1]")));
  }

  @Test
  void unknownKeysAreRefusedWithTheKeyThatWasProbablyMeant() throws Exception {
    JsonFields root = parse("{\"mas\": 1}");
    assertEquals(
        "a.json:1:2: unknown key \"mas\", did you mean mass? a link may have mass, com",
        refusal(() -> root.allow((key, known) -> Optional.of("mass"), "mass", "com")));
  }

  @Test
  void missingFilesOfTheProgramAreNamed() {
    assertEquals(
        "nothing.json is missing from this build",
        assertThrows(
                IllegalStateException.class,
                () -> JsonFile.ofResource(JsonFile.class, "nothing.json"))
            .getMessage());
  }
}
