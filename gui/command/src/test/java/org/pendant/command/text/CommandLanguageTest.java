package org.pendant.command.text;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class CommandLanguageTest {
  @Test
  void aLanguageThatIsNotSpokenIsRefusedWithThoseThatAre() {
    assertEquals(
        Optional.of("PENDANT_LANGUAGE is fr, must be one of en, de, zh"),
        CommandLanguage.refusal(Map.of("PENDANT_LANGUAGE", "fr")));
  }

  @Test
  void oneThatIsSpokenOrNoneIsNotRefused() {
    assertEquals(Optional.empty(), CommandLanguage.refusal(Map.of("PENDANT_LANGUAGE", "zh")));
    assertEquals(Optional.empty(), CommandLanguage.refusal(Map.of("PENDANT_LANGUAGE", "")));
    assertEquals(Optional.empty(), CommandLanguage.refusal(Map.of()));
  }
}
