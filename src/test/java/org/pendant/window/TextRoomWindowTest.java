package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.text.Language;
import org.pendant.window.TextTour.Part;

/**
 * That every text of a small window has the room it needs, in every language. A build looks at the
 * screens in the language with the longest words, {@code -Dpendant.texts=all} at all parts in all.
 */
@Tag("slow")
final class TextRoomWindowTest {
  @TempDir Path folder;

  @Test
  void screensHaveRoomForGerman() throws IOException {
    assertNothingCut(Language.GERMAN, EnumSet.of(Part.SCREENS));
  }

  @ParameterizedTest
  @EnumSource
  @EnabledIfSystemProperty(named = "pendant.texts", matches = "all")
  void everythingHasRoomForEveryLanguage(Language language) throws IOException {
    assertNothingCut(language, EnumSet.allOf(Part.class));
  }

  private void assertNothingCut(Language language, Set<Part> parts) throws IOException {
    try (VirtualDisplay display = VirtualDisplay.start("1024x700")) {
      TextTour.Report report = TextTour.of(language, display, folder, parts);
      assertEquals("", String.join("\n", report.cut()), report.lookedAt());
      assertNotEquals("0 components, 0 texts", report.lookedAt());
      assertTrue(
          report.items().containsAll(List.of("menu-edit-cut", "menu-edit-copy", "menu-edit-paste")),
          "actions have the same names in every language");
    }
  }
}
