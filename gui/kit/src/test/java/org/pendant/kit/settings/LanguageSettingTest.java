package org.pendant.kit.settings;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.UIDefaults;
import javax.swing.UIManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.text.Language;

final class LanguageSettingTest {
  private final Locale before = Locale.getDefault(Locale.Category.DISPLAY);
  private final MemorySettings settings = new MemorySettings();
  private final LanguageSetting language = new LanguageSetting(settings);

  @AfterEach
  void speakAsBefore() {
    Locale.setDefault(Locale.Category.DISPLAY, before);
    JComponent.setDefaultLocale(before);
  }

  @Test
  void withoutAChoiceTheProcessSpeaksTheLanguageOfTheSystem() {
    Locale.setDefault(Locale.Category.DISPLAY, Locale.GERMAN);
    language.apply(Map.of());
    assertEquals(Language.GERMAN, Language.ofProcess());
    assertEquals(Locale.GERMAN, JComponent.getDefaultLocale());
  }

  @Test
  void dialogsOfSwingSpeakChineseToo() {
    new LanguageSetting(settings).apply(Map.of(Language.VARIABLE, "zh"));
    UIDefaults texts = UIManager.getLookAndFeelDefaults();
    assertEquals(
        "\u53d6\u6d88",
        texts.getString("FileChooser.cancelButtonText", JComponent.getDefaultLocale()));
  }

  @Test
  void aChoiceHoldsFromTheNextStartOnAndLeavesNumbersAlone() {
    Locale numbers = Locale.getDefault(Locale.Category.FORMAT);
    language.choose(Optional.of(Language.CHINESE));
    assertEquals(Language.ENGLISH, Language.ofProcess());
    new LanguageSetting(settings).apply(Map.of());
    assertEquals(Language.CHINESE, Language.ofProcess());
    assertEquals(numbers, Locale.getDefault(Locale.Category.FORMAT));
  }

  @Test
  void theEnvironmentAsksForALanguageInPlaceOfTheSystemsWhereNoneIsChosen() {
    Locale.setDefault(Locale.Category.DISPLAY, Locale.GERMAN);
    Map<String, String> chinese = Map.of("PENDANT_LANGUAGE", "zh");
    language.apply(chinese);
    assertEquals(Language.CHINESE, Language.ofProcess());
    assertEquals(Locale.SIMPLIFIED_CHINESE, JComponent.getDefaultLocale());
    language.choose(Optional.of(Language.ENGLISH));
    language.apply(chinese);
    assertEquals(Language.ENGLISH, Language.ofProcess());
  }

  @Test
  void aLanguageThatNobodySpeaksHereIsNoChoice() {
    settings.put("window.language", "tlh");
    assertEquals(Optional.empty(), language.chosen());
    language.choose(Optional.of(Language.GERMAN));
    language.choose(Optional.empty());
    assertEquals(Optional.empty(), language.chosen());
  }
}
