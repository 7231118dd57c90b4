package org.pendant.desktop.editor;

import java.awt.Color;
import java.util.EnumMap;
import java.util.Map;
import org.pendant.kit.theme.Palette;
import org.pendant.language.service.HighlightToken.Style;

/**
 * Editor colours: the colours of code in one theme. Every class of words has a contrast of at least
 * 4.5 to the backgrounds that code stands on.
 */
record EditorColors(
    Color background,
    Color text,
    Color currentLine,
    Color executionLine,
    Color failedLine,
    Color selection,
    Color match,
    Color bracket,
    Color lineNumber,
    Color gutterLine,
    Map<Style, Color> styles) {

  static final EditorColors LIGHT =
      new EditorColors(
          new Color(0xFFFFFF),
          new Color(0x1F2328),
          new Color(0xF1F4F8),
          new Color(0xD9F0DF),
          new Color(0xFBE3E1),
          new Color(0xC8DDF5),
          new Color(0xFFE59A),
          new Color(0xD5E3F3),
          new Color(0x666D76),
          new Color(0xE3E6EA),
          styles(
              0x6F2DBD, 0x0A4A9E, 0x0B5A63, 0x8A3300, 0x4A4458, 0x0F4C8A, 0x0F5A26, 0x525A64,
              0x6B4300, 0x1F2328));

  static final EditorColors DARK =
      new EditorColors(
          new Color(0x1E2125),
          new Color(0xD9DEE5),
          new Color(0x272B30),
          new Color(0x1F3A29),
          new Color(0x4A2626),
          new Color(0x26405E),
          new Color(0x5C4A00),
          new Color(0x34485E),
          new Color(0x8D96A1),
          new Color(0x33383E),
          styles(
              0xCFB2FF, 0x93C2FF, 0x6FD8CC, 0xFFC08A, 0xC3CCD8, 0xA5D5FF, 0xA5DE95, 0xB6BEC8,
              0xE8C987, 0xD9DEE5));

  /** Those of the present theme. */
  static EditorColors now() {
    return Palette.dark() ? DARK : LIGHT;
  }

  Color of(Style style) {
    return styles.get(style);
  }

  private static Map<Style, Color> styles(
      int keyword,
      int function,
      int builtin,
      int parameter,
      int member,
      int number,
      int string,
      int comment,
      int label,
      int other) {
    Map<Style, Color> colors = new EnumMap<>(Style.class);
    for (Style style : Style.values()) {
      int color =
          switch (style) {
            case KEYWORD -> keyword;
            case FUNCTION -> function;
            case BUILTIN -> builtin;
            case PARAMETER -> parameter;
            case MEMBER -> member;
            case NUMBER -> number;
            case STRING -> string;
            case COMMENT -> comment;
            case LABEL -> label;
            case VARIABLE, OPERATOR, UNKNOWN -> other;
          };
      colors.put(style, new Color(color));
    }
    return Map.copyOf(colors);
  }
}
