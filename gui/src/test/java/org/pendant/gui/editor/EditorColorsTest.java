package org.pendant.gui.editor;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
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
        double contrast = contrast(colors.of(style), background);
        assertTrue(contrast >= 4.5, style + " on " + background + " has contrast " + contrast);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("themes")
  void lineNumbersAreReadable(EditorColors colors) {
    assertTrue(contrast(colors.lineNumber(), colors.background()) >= 4.5);
  }

  /** WCAG 2.2, contrast ratio. */
  private static double contrast(Color one, Color other) {
    double lighter = Math.max(luminance(one), luminance(other));
    double darker = Math.min(luminance(one), luminance(other));
    return (lighter + 0.05) / (darker + 0.05);
  }

  private static double luminance(Color color) {
    double[] linear =
        DoubleStream.of(color.getRed(), color.getGreen(), color.getBlue())
            .map(value -> value / 255)
            .map(value -> value <= 0.04045 ? value / 12.92 : Math.pow((value + 0.055) / 1.055, 2.4))
            .toArray();
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
  }
}
