package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.models.json.JsonException;

/** What the reader says about files that are no scenes. */
final class SceneRefusalTest {

  private static void assertRefused(String message, String text) {
    assertRefused(message, text.getBytes(StandardCharsets.UTF_8));
  }

  private static void assertRefused(String message, byte[] bytes) {
    assertEquals(
        message,
        assertThrows(
                JsonException.class,
                () -> SceneReader.read("scene.json", new ByteArrayInputStream(bytes)))
            .getMessage());
  }

  /** A scene with one object, its braces at columns 14 and after. */
  private static String object(String members) {
    return "{\"objects\": [{" + members + "}]}";
  }

  private static String sphere(String members) {
    return object("\"type\": \"sphere\", \"name\": \"s\",\n" + members);
  }

  private static String box(String members) {
    return object("\"type\": \"box\", \"name\": \"b\",\n" + members);
  }

  private static String plane(String members) {
    return object("\"type\": \"plane\", \"name\": \"p\",\n" + members);
  }

  @Test
  void textThatIsNotJson() {
    assertRefused("scene.json:1:1: the file is empty, must be an object", "");
    assertRefused("scene.json:2:1: not JSON: the file ends too early", "{\"objects\": [\n");
    assertRefused(
        "scene.json:2:2: not JSON: Unexpected character ('l' (code 108)): was expecting"
            + " double-quote to start property name",
        "{\n load: 1}");
    assertRefused(
        "scene.json:1:1: not JSON: Unexpected character ('/' (code 47)): maybe a (non-standard)"
            + " comment?",
        "// a scene\n{}");
    assertRefused(
        "scene.json:1:13: not JSON: Unexpected close marker '}': expected ']'", "{\"objects\":[}");
    assertRefused(
        "scene.json:1:22: not JSON: Non-standard token 'NaN'", "{\"load\": {\"mass\": NaN}}");
  }

  @Test
  void moreThanOneValue() {
    assertRefused(
        "scene.json:2:1: there is more text after the end of the object, must be one object",
        "{}\n{}");
  }

  @Test
  void bytesThatAreNoLetters() {
    byte[] latin = "{\n\"caf\u00e9\": 1}".getBytes(StandardCharsets.ISO_8859_1);
    assertRefused("scene.json:2:5: a byte is no letter, the file must be in UTF-8", latin);
  }

  @Test
  void lettersCutShortAtTheEnd() {
    byte[] cut = {'{', '}', (byte) 0xc3};
    assertRefused("scene.json:1:3: a byte is no letter, the file must be in UTF-8", cut);
  }

  @Test
  void columnsCountLettersNotBytes() {
    assertRefused(
        "scene.json:1:47: unknown key \"x\", a sphere may have type, name, centre, radius,"
            + " mass, material",
        object("\"type\": \"sphere\", \"name\":\"\u00e9\u00e9\u00e9\", \"x\":1"));
  }

  @Test
  void fileThatIsTooLarge() {
    assertRefused(
        "scene.json: has more than 1048576 bytes, must be at most that many",
        " ".repeat((1 << 20) + 1));
  }

  @Test
  void fileThatCannotBeRead() throws IOException {
    InputStream closed = InputStream.nullInputStream();
    closed.close();
    assertEquals(
        "scene.json: cannot be read, Stream closed",
        assertThrows(JsonException.class, () -> SceneReader.read("scene.json", closed))
            .getMessage());
  }

  @Test
  void valuesTooDeepWithinOneAnother() {
    assertRefused("scene.json:1:9: more than 8 values within one another", "[".repeat(100_000));
  }

  @Test
  void numbersOfTooManyDigits() {
    assertRefused(
        "scene.json:1:1002: not JSON: Number value length (1001) exceeds the maximum allowed"
            + " (1000)",
        "1".repeat(1001));
  }

  @Test
  void rootThatIsNoObject() {
    assertRefused("scene.json:1:1: a scene is an array of 0, must be an object", "[]");
    assertRefused("scene.json:1:1: a scene is 4, must be an object", "4");
    assertRefused("scene.json:1:1: a scene is null, must be an object", "null");
  }

  @Test
  void linksThatNeitherStopNorPass() {
    assertRefused(
        "scene.json:1:11: links is \"slide\", must be stop or pass", "{\"links\": \"slide\"}");
    assertRefused("scene.json:1:11: links is true, must be a text", "{\"links\": true}");
  }

  @Test
  void unknownKeys() {
    assertRefused(
        "scene.json:1:2: unknown key \"object\", did you mean objects? a scene may have objects,"
            + " load, tool, push, links, devices, rules, arms, script, wires",
        "{\"object\": []}");
    assertRefused(
        "scene.json:2:1: unknown key \"center\", did you mean centre? a sphere may have type, name,"
            + " centre, radius, mass, material",
        sphere("\"center\": [0, 0, 0]"));
    assertRefused(
        "scene.json:2:1: unknown key \"colour\", a box may have type, name, pose, size, mass,"
            + " material",
        box("\"colour\": \"red\""));
    assertRefused(
        "scene.json:2:1: unknown key \"nromal\", did you mean normal? a plane may have type, name,"
            + " point, normal, material",
        plane("\"nromal\": [0, 0, 1]"));
    assertRefused(
        "scene.json:1:11: unknown key \"weight\", a load may have mass, cog, inertia",
        "{\"load\": {\"weight\": 1}}");
    assertRefused(
        "scene.json:1:12: unknown key \"r\", a tool point may have point, radius",
        "{\"tool\": [{\"r\": 1}]}");
    assertRefused(
        "scene.json:2:62: unknown key \"mu\", a material may have stiffness, damping, friction,"
            + " restitution",
        sphere("\"centre\": [0, 0, 0], \"radius\": 1, \"material\": {\"damping\": 1, \"mu\": 1}"));
  }

  @Test
  void keysThatAreThereTwice() {
    assertRefused(
        "scene.json:1:14: key \"load\" again, must be there once", "{\"load\": {}, \"load\": {}}");
  }

  @Test
  void keysThatAreMissing() {
    assertRefused(
        "scene.json:1:14: key \"type\" is missing, an object of the scene must have it",
        object(""));
    assertRefused(
        "scene.json:1:14: key \"name\" is missing, a sphere must have it",
        object("\"type\": \"sphere\""));
    assertRefused(
        "scene.json:1:14: key \"radius\" is missing, a sphere must have it",
        sphere("\"centre\": [0, 0, 0]"));
    assertRefused(
        "scene.json:1:14: key \"pose\" is missing, a box must have it", box("\"size\": [1, 1, 1]"));
    assertRefused(
        "scene.json:1:14: key \"normal\" is missing, a plane must have it",
        plane("\"point\": [0, 0, 0]"));
    assertRefused(
        "scene.json:1:10: key \"mass\" is missing, a load must have it", "{\"load\": {}}");
    assertRefused(
        "scene.json:1:11: key \"point\" is missing, a tool point must have it", "{\"tool\": [{}]}");
  }

  @Test
  void valuesOfTheWrongKind() {
    assertRefused(
        "scene.json:1:13: objects is an object, must be an array of at most 1000",
        "{\"objects\": {}}");
    assertRefused(
        "scene.json:1:14: an object of the scene is true, must be an object",
        "{\"objects\": [true]}");
    assertRefused("scene.json:1:10: a load is \"2\", must be an object", "{\"load\": \"2\"}");
    assertRefused("scene.json:1:23: type is 3, must be a text", object("\"type\": 3"));
    assertRefused(
        "scene.json:1:41: name is null, must be a text",
        object("\"type\": \"sphere\", \"name\": null"));
    assertRefused(
        "scene.json:2:11: centre is 0, must be an array of 3 numbers",
        sphere("\"centre\": 0, \"radius\": 1"));
    assertRefused(
        "scene.json:2:11: centre is an array of 2, must be an array of 3 numbers",
        sphere("\"centre\": [0, 0], \"radius\": 1"));
    assertRefused(
        "scene.json:2:18: centre[2] is \"up\", must be a number",
        sphere("\"centre\": [0, 0, \"up\"], \"radius\": 1"));
    assertRefused(
        "scene.json:2:32: radius is an array of 1, must be a number",
        sphere("\"centre\": [0, 0, 0], \"radius\": [1]"));
    assertRefused(
        "scene.json:2:47: a material is \"steel\", must be an object",
        sphere("\"centre\": [0, 0, 0], \"radius\": 1, \"material\": \"steel\""));
  }

  @Test
  void typesThatDoNotExist() {
    assertRefused(
        "scene.json:1:23: type is \"ball\", must be plane, box, sphere, cylinder,"
            + " capsule, mesh or compound",
        object("\"type\": \"ball\""));
  }

  @Test
  void namesThatCannotBe() {
    assertRefused(
        "scene.json:1:41: name is \"\", must be 1 to 60 letters",
        object("\"type\": \"sphere\", \"name\": \"\""));
    assertRefused(
        "scene.json:3:26: name is \"wall\" as in line 2, must be another for each object",
        """
        {"objects": [
        {"type": "sphere", "name": "wall", "centre": [0, 0, 0], "radius": 1},
        {"type": "plane", "name":"wall", "point": [0, 0, 0], "normal": [0, 0, 1]}
        ]}\
        """
            .replace("\"plane\",  \"name\": ", "\"plane\", \"name\":"));
  }

  @Test
  void numbersOutsideTheirRange() {
    assertRefused(
        "scene.json:2:18: centre[2] is 11 m, must be -10 to 10 m",
        sphere("\"centre\": [0, 0, 11], \"radius\": 1"));
    assertRefused(
        "scene.json:2:32: radius is 0 m, must be 0.001 to 10 m",
        sphere("\"centre\": [0, 0, 0], \"radius\": 0"));
    assertRefused(
        "scene.json:2:32: radius is Infinity m, must be 0.001 to 10 m",
        sphere("\"centre\": [0, 0, 0], \"radius\": 1e999"));
    assertRefused(
        "scene.json:2:10: pose[0] is -20 m, must be -10 to 10 m",
        box("\"pose\": [-20, 0, 0, 0, 0, 0], \"size\": [1, 1, 1]"));
    assertRefused(
        "scene.json:2:24: pose[5] is 180 rad, must be -100 to 100 rad",
        box("\"pose\": [0, 0, 0, 0, 0,180], \"size\": [1, 1, 1]"));
    assertRefused(
        "scene.json:2:40: size[1] is -1 m, must be 0.001 to 10 m",
        box("\"pose\": [0, 0, 0, 0, 0, 0], \"size\": [1,-1, 1]"));
    assertRefused(
        "scene.json:2:31: length of normal is 0, must be 0.001 to 1000",
        plane("\"point\": [0, 0, 0], \"normal\": [0, 0, 0]"));
    assertRefused(
        "scene.json:2:32: normal[0] is 5000, must be -1000 to 1000",
        plane("\"point\": [0, 0, 0], \"normal\": [5000, 0, 0]"));
  }

  @Test
  void materialsOutsideTheirRange() {
    String start = "\"centre\": [0, 0, 0], \"radius\": 1,\n\"material\": {";
    assertRefused(
        "scene.json:3:27: stiffness is 1000000 N/m, must be 10 to 200000 N/m",
        sphere(start + "\"stiffness\": 1e6}"));
    assertRefused(
        "scene.json:3:25: damping is 3 s/m, must be 0 to 2 s/m", sphere(start + "\"damping\": 3}"));
    assertRefused(
        "scene.json:3:26: friction is -0.1, must be 0 to 2", sphere(start + "\"friction\": -0.1}"));
  }

  @Test
  void loadsOutsideTheirRange() {
    assertRefused(
        "scene.json:1:19: mass is -1 kg, must be 0 to 100 kg", "{\"load\": {\"mass\": -1}}");
    assertRefused(
        "scene.json:1:36: cog[2] is 9 m, must be -4 to 4 m",
        "{\"load\": {\"mass\": 1, \"cog\": [0, 0, 9]}}");
    assertRefused(
        "scene.json:1:34: inertia[0] is -1 kg m\u00b2, must be 0 to 133 kg m\u00b2",
        "{\"load\": {\"mass\": 1, \"inertia\": [-1, 0, 0, 0, 0, 0]}}");
    assertRefused(
        "scene.json:1:49: inertia[5] is 134 kg m\u00b2, must be -133 to 133 kg m\u00b2",
        "{\"load\": {\"mass\": 1, \"inertia\": [1, 1, 1, 0, 0, 134]}}");
  }

  @Test
  void inertiasOfNoBody() {
    String end =
        " kg m\u00b2, which no body has: about any axis it must be at most the sum of those"
            + " about two axes across";
    assertRefused(
        "scene.json:1:33: inertia is [3.0, 1.0, 1.0, 0.0, 0.0, 0.0]" + end,
        "{\"load\": {\"mass\": 1, \"inertia\": [3, 1, 1, 0, 0, 0]}}");
    assertRefused(
        "scene.json:1:33: inertia is [1.0, 1.0, 1.0, 0.0, 0.0, 0.6]" + end,
        "{\"load\": {\"mass\": 1, \"inertia\": [1, 1, 1, 0, 0, 0.6]}}");
    assertRefused(
        "scene.json:1:33: inertia is [0.2, 0.2, 0.2, 0.1, 0.1, 0.1]" + end,
        "{\"load\": {\"mass\": 1, \"inertia\": [0.2, 0.2, 0.2, 0.1, 0.1, 0.1]}}");
  }

  @Test
  void toolPointsOutsideTheirRange() {
    assertRefused(
        "scene.json:1:22: point[0] is 5 m, must be -4 to 4 m",
        "{\"tool\": [{\"point\": [5, 0, 0]}]}");
    assertRefused(
        "scene.json:1:42: radius is 2 m, must be 0 to 1 m",
        "{\"tool\": [{\"point\": [0, 0, 0], \"radius\": 2}]}");
  }

  @Test
  void tooManyOfAKind() {
    assertRefused(
        "scene.json:1:13: objects is an array of 1001, must be an array of at most 1000",
        "{\"objects\": [" + "{},".repeat(1000) + "{}]}");
    assertRefused(
        "scene.json:1:10: tool is an array of 33, must be an array of at most 32",
        "{\"tool\": [" + "{},".repeat(32) + "{}]}");
    assertRefused(
        "scene.json:1:347: tool has more than 16 points",
        "{\"tool\": [" + "{\"point\": [0, 0, 0]},".repeat(16) + "{\"point\": [0, 0, 0]}]}");
  }
}
