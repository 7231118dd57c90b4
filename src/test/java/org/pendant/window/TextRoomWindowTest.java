package org.pendant.window;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
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
    TextTour.Report report = assertNothingCut(Language.GERMAN, Part.SCREENS);
    assertTrue(
        report.names().containsAll(List.of("card-joints", "card-digital-in", "card-mounting")),
        () -> "cards have the same names in every language: " + report.names());
  }

  @ParameterizedTest
  @EnumSource
  @EnabledIfSystemProperty(named = "pendant.texts", matches = "all")
  void everythingHasRoomForEveryLanguage(Language language) {
    assertAll(
        EnumSet.allOf(Part.class).stream().map(each -> () -> assertNothingCut(language, each)));
  }

  /** A part has a window of its own: what one leaves open is not in the way of the next. */
  private TextTour.Report assertNothingCut(Language language, Part part) throws IOException {
    Path own = Files.createDirectories(folder.resolve(part.name()));
    try (VirtualDisplay display = VirtualDisplay.start("1024x700")) {
      TextTour.Report report = TextTour.of(language, display, own, part);
      assertEquals("", String.join("\n", report.cut()), report.lookedAt());
      assertNotEquals("0 components, 0 texts", report.lookedAt());
      assertTrue(
          report.names().containsAll(List.of("menu-edit-cut", "menu-edit-copy", "menu-edit-paste")),
          "actions have the same names in every language");
      return report;
    }
  }
}
