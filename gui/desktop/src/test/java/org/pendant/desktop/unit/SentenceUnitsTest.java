package org.pendant.desktop.unit;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class SentenceUnitsTest {
  @Test
  void aUnitEndsBeforeAnyLetterOfAWord() {
    assertEquals(
        "Handgelenk 3 m\u00fcsste sich drehen",
        SentenceUnits.in("Handgelenk 3 m\u00fcsste sich drehen", PoseForm.STANDARD));
  }

  @Test
  void aUnitMayEndBeforeALetterOfALanguageWithoutSpaces() {
    assertEquals(
        "\u5728 500.00 mm\u5904", SentenceUnits.in("\u5728 0.5 m\u5904", PoseForm.STANDARD));
  }
}
