package org.pendant.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class LanguageTest {
  @Test
  void countsAreGroupedByWhatIsNoDecimalPoint() {
    assertEquals("1,234,567", Language.ENGLISH.grouped(1_234_567));
    assertEquals("1\u202f234\u202f567", Language.GERMAN.grouped(1_234_567));
    assertEquals("1,234,567", Language.CHINESE.grouped(1_234_567));
    assertEquals("999", Language.GERMAN.grouped(999));
  }

  @Test
  void whatIsToldOfSomethingStandsBehindTheColonOfTheLanguage() {
    assertEquals("Power: too much", Language.ENGLISH.told("Power", "too much"));
    assertEquals("Leistung: zu viel", Language.GERMAN.told("Leistung", "zu viel"));
    assertEquals("功率：过大", Language.CHINESE.told("功率", "过大"));
  }

  @Test
  void titlesKeepTheirCapitalInASentenceWhereTheLanguageHasIt() {
    assertEquals("speed", Language.ENGLISH.withinSentence("Speed"));
    assertEquals("TCP", Language.ENGLISH.withinSentence("TCP"));
    assertEquals("Geschwindigkeit", Language.GERMAN.withinSentence("Geschwindigkeit"));
  }
}
