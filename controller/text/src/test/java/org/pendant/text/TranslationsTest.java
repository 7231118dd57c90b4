package org.pendant.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

class TranslationsTest {
  private final Translations german = in(Language.GERMAN);

  private static Translations in(Language language) {
    return Translations.of(
        language, TranslationsTest.class.getClassLoader(), List.of("translated"));
  }

  @Test
  void aTextWithoutValuesIsSaidInTheOtherLanguage() {
    assertEquals("Basisgelenk", german.of("base joint"));
  }

  @Test
  void valuesStandWhereTheOtherLanguageWantsThemAndAreTranslatedOnlyIfTheyAreTexts() {
    assertEquals(
        "Mit 91.5 Grad ist Ellbogen nicht erlaubt: erlaubt sind -90 bis 90 Grad",
        german.of("the elbow is at 91.5 deg, must be -90 to 90 deg"));
    assertEquals("elbow wird abgelehnt", german.of("elbow is refused"));
  }

  @Test
  void ofTextsThatFitTheOneThatLeavesLeastToValuesIsMeant() {
    assertEquals("Zeile 3: base wird abgelehnt", german.of("line 3: base is refused"));
  }

  @Test
  void aPlaceThatIsThereTwiceHasOneValue() {
    assertEquals("zweimal a", german.of("a and a"));
    assertEquals("a and b", german.of("a and b"));
  }

  @Test
  void whatIsNotRecognisedStaysAsItIs() {
    assertEquals("picked 3 of 7", german.of("picked 3 of 7"));
    assertEquals("1: 2", german.of("1: 2"));
    assertEquals("", german.of(""));
  }

  @Test
  void aTextBehindAPlaceAndTextsBesideEachOtherAreSaid() {
    assertEquals("arm.json:3: Ellbogen", german.of("arm.json:3: elbow"));
    assertEquals("base wird abgelehnt; Ellbogen", german.of("base is refused; elbow"));
    assertEquals("picked: 3; of 7", german.of("picked: 3; of 7"));
  }

  @Test
  void aSentenceWhereATextHasANameIsNotTakenForOne() {
    assertEquals("where the lamp is refused", german.of("where the lamp is refused"));
    assertEquals("big lamp.script wird abgelehnt", german.of("big lamp.script is refused"));
  }

  @Test
  void aMessageIsRecognisedBehindTheNameOfWhatSaysIt() {
    assertEquals("left arm: elbow wird abgelehnt", german.of("left arm: elbow is refused"));
  }

  @Test
  void aMessageWithoutMeasureStaysAsItIs() {
    String name = "x".repeat(Translations.MAX_LENGTH);
    assertEquals(name + " is refused", german.of(name + " is refused"));
  }

  @Test
  void linesOfSeveralTextsAreSaidOneByOne() {
    assertEquals("Ellbogen\nmine\nBasisgelenk\n", german.of("elbow\nmine\nbase joint\n"));
  }

  @Test
  void textsWithinTextsAreFollowedSoFarThatNothingCanGoOnForEver() {
    String nested = "line 1: ".repeat(100) + "elbow";
    assertEquals("Zeile 1: ".repeat(4) + "line 1: ".repeat(96) + "elbow", german.of(nested));
  }

  @Test
  void englishStaysEnglish() {
    assertEquals("elbow", in(Language.ENGLISH).of("elbow"));
  }

  @Test
  void bundlesOfModulesThatAreNotThereAreLeftOut() {
    ClassLoader loader = TranslationsTest.class.getClassLoader();
    Translations some = Translations.of(Language.GERMAN, loader, List.of("nobody", "translated"));
    assertEquals("Basisgelenk", some.of("base joint"));
  }
}
