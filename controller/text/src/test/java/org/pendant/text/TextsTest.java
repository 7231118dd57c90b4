package org.pendant.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Locale;
import java.util.MissingResourceException;
import org.junit.jupiter.api.Test;

class TextsTest {
  private final Texts german = Texts.of(TextsTest.class, Language.GERMAN);
  private final Texts english = Texts.of(TextsTest.class, Language.ENGLISH);

  @Test
  void aTextIsSaidInTheLanguageAskedFor() {
    assertEquals("Speichern", german.get("save"));
    assertEquals("Save", english.get("save"));
  }

  @Test
  void whatWasNotTranslatedIsSaidInEnglish() {
    assertEquals("Not yet translated", german.get("notYet"));
  }

  @Test
  void valuesStandWhereTheLanguageWantsThem() {
    assertEquals("3 of 7 runs", english.get("runs", 3, 7));
    assertEquals("Von 7 Läufen 3", german.get("runs", 3, 7));
  }

  @Test
  void aValueThatIsATextItselfIsTranslatedWhereTheLanguageSaysSo() {
    Texts said =
        Texts.of(TextsTest.class, Language.GERMAN, text -> text.equals("full") ? "voll" : text);
    assertEquals("disk full: voll (full)", said.get("failed", "full"));
    assertEquals("disk full: full (full)", german.get("failed", "full"));
    assertEquals("disk full: full", english.get("failed", "full"));
  }

  @Test
  void aSpaceIsBetweenChineseCharactersAndLatinLettersOrDigits() {
    Texts chinese = Texts.of(TextsTest.class, Language.CHINESE);
    assertEquals("显示 Log 的 3 行", chinese.get("rows", "Log", 3));
    assertEquals("显示日志的全部行", chinese.get("rows", "日志", "全部"));
    assertEquals("显示“Log”的 3 行", chinese.get("rows", "“Log”", " 3 "));
  }

  @Test
  void apostrophesAndBracesThatAreNoPlacesStayAndValuesAreNotReadAgain() {
    assertEquals("It isn't {x} {2}, {", english.get("odd", "{x}"));
    assertEquals("It isn't {1} {2}, {", english.get("odd", "{1}"));
  }

  @Test
  void aKeyWithoutTextIsAMistakeOfTheProgram() {
    assertThrows(MissingResourceException.class, () -> english.get("nothing"));
  }

  @Test
  void aLocaleOfALanguageThatIsNotSpokenHereIsAnsweredInEnglish() {
    assertEquals(Language.ENGLISH, Language.of(Locale.FRENCH));
    assertEquals(Language.GERMAN, Language.of(Locale.forLanguageTag("de-AT")));
    assertEquals(Language.CHINESE, Language.of(Locale.SIMPLIFIED_CHINESE));
  }

  @Test
  void aTitleWithinASentenceHasASmallLetterWhereTheLanguageWantsIt() {
    assertEquals("joint speed", Language.ENGLISH.withinSentence("Joint speed"));
    assertEquals("TCP", Language.ENGLISH.withinSentence("TCP"));
    assertEquals("", Language.ENGLISH.withinSentence(""));
    assertEquals("Achsgeschwindigkeit", Language.GERMAN.withinSentence("Achsgeschwindigkeit"));
  }
}
