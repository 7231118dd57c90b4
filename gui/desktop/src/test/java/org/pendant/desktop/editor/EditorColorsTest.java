package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.kit.theme.Contrast;
import org.pendant.language.service.HighlightToken.Style;

final class EditorColorsTest {

  static List<EditorColors> themes() {
    return List.of(EditorColors.LIGHT, EditorColors.DARK);
  }

  @ParameterizedTest
  @MethodSource("themes")
  void everyKindOfWordIsReadableOnEveryBackground(EditorColors colors) {
    List<Color> backgrounds =
        List.of(
            colors.background(),
            colors.currentLine(),
            colors.executionLine(),
            colors.failedLine(),
            colors.selection(),
            colors.bracket(),
            colors.match());
    for (Style style : Style.values()) {
      for (Color background : backgrounds) {
        double contrast = Contrast.of(colors.of(style), background);
        assertTrue(contrast >= 4.5, style + " on " + background + " has contrast " + contrast);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("themes")
  void lineNumbersAreReadable(EditorColors colors) {
    assertTrue(Contrast.of(colors.lineNumber(), colors.background()) >= 4.5);
  }
}
