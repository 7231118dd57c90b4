package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.arm.ArmLibrary;

final class RobotNameTest {

  private static String refusal(String word) {
    return assertThrows(UsageException.class, () -> RobotName.idOf(() -> "--robot", word))
        .getMessage();
  }

  @Test
  void idsAndDisplayNamesAreUnderstood() throws UsageException {
    assertEquals("ur10e", RobotName.idOf(() -> "--robot", "ur10e"));
    assertEquals("ur10e", RobotName.idOf(() -> "--robot", "UR10e"));
    assertEquals("ur8long", RobotName.idOf(() -> "--robot", "UR8 Long"));
  }

  @ParameterizedTest
  @CsvSource({"ur16, ur16e", "UR8, ur8long", "ur5r, ur5", "u10e, ur10e", "UR-20, ur20"})
  void unknownNameGetsTheOneThatWasProbablyMeant(String word, String likely) {
    String message = refusal(word);
    assertTrue(message.endsWith("; did you mean " + likely + "?"), message);
  }

  @Test
  void aNameThatEndsInJsonIsAFile() {
    assertTrue(RobotName.isFile("my-arm.json") && RobotName.isFile("arms/UR5E.JSON"));
    assertFalse(RobotName.isFile("ur5e"));
  }

  @Test
  void unknownNameGetsTheWholeList() {
    assertEquals(
        "--robot is nosuch, must be one of " + String.join(", ", ArmLibrary.ids()),
        refusal("nosuch"));
    assertFalse(refusal("").contains("did you mean"));
  }
}
