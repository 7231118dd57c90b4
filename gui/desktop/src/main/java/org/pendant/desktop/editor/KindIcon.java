package org.pendant.desktop.editor;

import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.RoundRectangle2D;
import javax.swing.Icon;
import org.pendant.kit.theme.Palette;
import org.pendant.language.service.Completion;
import org.pendant.language.service.HighlightToken.Style;
import org.pendant.language.service.OutlineItem;

/** Kind icon: a letter in a rounded square, in the colour that such names have in the text. */
record KindIcon(String letter, Style style) implements Icon {
  private static final int SIZE = 16;

  static KindIcon of(Completion.Kind kind) {
    return switch (kind) {
      case ARGUMENT -> new KindIcon("=", Style.PARAMETER);
      case MEMBER -> new KindIcon("m", Style.MEMBER);
      case METHOD -> new KindIcon("f", Style.BUILTIN);
      case PARAMETER -> new KindIcon("p", Style.PARAMETER);
      case LOCAL -> new KindIcon("v", Style.VARIABLE);
      case GLOBAL -> new KindIcon("g", Style.VARIABLE);
      case FUNCTION -> new KindIcon("f", Style.FUNCTION);
      case THREAD -> new KindIcon("t", Style.FUNCTION);
      case KEYWORD -> new KindIcon("k", Style.KEYWORD);
      case SNIPPET -> new KindIcon("\u2026", Style.KEYWORD);
      case BUILTIN -> new KindIcon("f", Style.BUILTIN);
    };
  }

  static KindIcon of(OutlineItem.Kind kind) {
    return switch (kind) {
      case FUNCTION -> new KindIcon("f", Style.FUNCTION);
      case SECONDARY -> new KindIcon("s", Style.BUILTIN);
      case THREAD -> new KindIcon("t", Style.KEYWORD);
      case GLOBAL -> new KindIcon("g", Style.VARIABLE);
    };
  }

  @Override
  public int getIconWidth() {
    return SIZE;
  }

  @Override
  public int getIconHeight() {
    return SIZE;
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    Color color = EditorColors.now().of(style);
    pen.setColor(Palette.tint(color, 0.16));
    pen.fill(new RoundRectangle2D.Double(x + 0.5, y + 0.5, SIZE - 1, SIZE - 1, 5, 5));
    pen.setColor(color);
    pen.setFont(EditorTheme.codeFont().deriveFont(Font.BOLD, 11f));
    FontMetrics metrics = pen.getFontMetrics();
    int left = x + (SIZE - metrics.stringWidth(letter)) / 2;
    pen.drawString(letter, left, y + 12);
    pen.dispose();
  }
}
