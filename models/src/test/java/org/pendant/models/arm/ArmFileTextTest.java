package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.json.JsonException;

/** Arm files that the program writes. */
class ArmFileTextTest {
  private static Stream<String> ids() {
    return ArmLibrary.ids().stream();
  }

  private static ArmDescription read(String text) throws JsonException {
    return ArmFile.read(
        "arm.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  @ParameterizedTest
  @MethodSource("ids")
  void everyArmIsReadAsItWasWritten(String id) throws JsonException {
    ArmDescription arm = ArmLibrary.load(id);

    assertEquals(arm, read(ArmFile.text(arm)));
  }

  @Test
  void notesMayHoldAnything() throws JsonException {
    ArmDescription arm = ArmLibrary.load("ur5e").withNotes(List.of("\"a\"\\\n\u00e9"));

    assertEquals(arm, read(ArmFile.text(arm)));
  }

  @Test
  void aDriveLagsAsUsualWhereTheFileDoesNotSay() throws JsonException {
    String text = ArmFile.text(ArmLibrary.load("ur5e"));
    String without = text.replaceAll("(?m)^ *\"lagS\".*\n", "");
    assertTrue(without.length() < text.length());

    assertEquals(Actuator.USUAL_LAG_S, read(without).actuators().get(3).lagS());
  }

  @Test
  void aLagOfMoreThanAFrameIsRefusedWithItsPlace() {
    String text =
        ArmFile.text(ArmLibrary.load("ur5e")).replaceFirst("\"lagS\" : [^,]*", "\"lagS\" : 0.003");

    JsonException refused = assertThrows(JsonException.class, () -> read(text));

    assertTrue(refused.getMessage().startsWith("arm.json:"), refused.getMessage());
    assertTrue(
        refused.getMessage().contains("lagS is 0.003 s, must be from 0 to 0.002"),
        refused.getMessage());
  }
}
