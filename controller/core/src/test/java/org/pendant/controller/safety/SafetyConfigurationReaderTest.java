package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.json.JsonException;

final class SafetyConfigurationReaderTest {
  private static final ArmDescription ARM = ArmLibrary.load("ur5e");
  private static final SafetyConfiguration STANDARD = SafetyConfiguration.standard(ARM);

  private static SafetyConfiguration read(String text) throws JsonException {
    return SafetyConfigurationReader.read(
        "cell.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), ARM);
  }

  @Test
  void everythingMayBeLeftOut() throws Exception {
    assertEquals(STANDARD, read("{}"));
  }

  @Test
  void exampleOfTheDocumentationIsRead() throws Exception {
    String page = Files.readString(Path.of("../../docs/safety.md"));
    int start = page.indexOf("```json\n") + "```json\n".length();
    SafetyConfiguration example = read(page.substring(start, page.indexOf("```", start)));
    assertEquals(1.0, example.normal().toolSpeedMPerS());
    assertEquals(STANDARD.normal().powerW(), example.normal().powerW());
    assertEquals(-3.2, example.normal().jointMinRad().q0());
    assertEquals(STANDARD.normal().jointMinRad().q1(), example.normal().jointMinRad().q1());
    assertEquals(0.25, example.reduced().toolSpeedMPerS());
    assertEquals(-3.2, example.reduced().jointMinRad().q0());
    assertEquals(
        List.of(
            new SafetyPlane("table", 0, 0, 0.02, new Axis(0, 0, 1), Applies.BOTH, true),
            new SafetyPlane(
                "aisle", 0, 0.5, 0, new Axis(0, -1, 0), Applies.TRIGGERS_REDUCED, false)),
        example.planes());
    assertEquals(
        Optional.of(new ToolDirection(new Axis(0, 0, -1), new Axis(0, 0, 1), 0.8, Applies.BOTH)),
        example.toolDirection());
  }

  @Test
  void lowerNormalLimitLowersTheReducedOne() throws Exception {
    SafetyConfiguration configuration = read("{\"normal\": {\"powerW\": 150}}");
    assertEquals(150, configuration.normal().powerW());
    assertEquals(150, configuration.reduced().powerW());
    assertEquals(STANDARD.reduced().toolForceN(), configuration.reduced().toolForceN());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '`',
      textBlock =
          """
          `[]` | 1:1: a safety configuration is an array of 0, must be an object
          `{"normal": 3}` | 1:12: the normal limits is 3, must be an object
          `{"normal": {"power": 3}}` | 1:13: unknown key "power", did you mean powerW? the normal
          `{"normal": {"powerW": "much"}}` | 1:23: powerW is "much", must be a number
          `{"normal": {"powerW": 0}}` | 1:23: powerW is 0 W, must be 1 to 10000 W
          `{"normal": {"jointMinRad": [1, 2]}}` | 1:28: jointMinRad is an array of 2, must be an array of 6 numbers
          `{"normal": {"jointMinRad": [0, 0, 0, 0, 0, 7]}}` | 1:12: safety limits: joint 5 may be at 7.0 to 6.33
          `{"reduced": {"toolForceN": 500}}` | 1:13: reduced limits: tool force is 500.0 N, must be at most the normal 150.0 N
          `{"planes": {}}` | 1:12: planes is an object, must be an array of at most 8
          `{"planes": [{"name": "a"}]}` | 1:13: key "pointM" is missing, a plane must have it
          `{"planes": [{"name": "a", "pointM": [0, 0, 11]}]}` | 1:44: pointM[2] is 11 m, must be -10 to 10 m
          `{"planes": [{"name": "a", "pointM": [0, 0, 1], "allowedSide": [0, 0, 0]}]}` | 1:63: allowedSide: direction is [0.0, 0.0, 0.0], must be finite and at least 0.001 long
          `{"planes": [{"name": "", "pointM": [0, 0, 1], "allowedSide": [0, 0, 1]}]}` | 1:22: safety plane: name is blank, must have a letter
          `{"planes": [{"name": "a", "pointM": [0, 0, 1], "allowedSide": [0, 0, 1], "applies": "never"}]}` | 1:85: applies is "never", must be one of normal, reduced, both, triggers_reduced
          `{"planes": [{"name": "a", "pointM": [0, 0, 1], "allowedSide": [0, 0, 1], "elbow": 1}]}` | 1:83: elbow is 1, must be true or false
          `{"planes": [{"name": "a", "pointM": [0, 0, 1], "allowedSide": [0, 0, 1]}, {"name": "a", "pointM": [0, 0, 1], "allowedSide": [0, 0, 1]}]}` | 1:12: two safety planes are called "a", each must have its own name
          `{"toolDirection": {"allowedInBase": [0, 0, 1]}}` | 1:19: key "largestAngleRad" is missing, a tool direction must have it
          `{"toolDirection": {"allowedInBase": [0, 0, 1], "largestAngleRad": 4}}` | 1:67: largestAngleRad is 4 rad, must be 0.001 to 3.141 rad
          `{"toolDirection": {"allowedInBase": [0, 0, 1], "largestAngleRad": 1, "applies": "triggers_reduced"}}` | 1:81: applies is "triggers_reduced", must be one of normal, reduced, both
          """)
  void mistakesAreNamedWithTheirPlace(String text, String message) {
    String found = assertThrows(JsonException.class, () -> read(text)).getMessage();
    assertTrue(found.startsWith("cell.json:" + message), found);
  }
}
