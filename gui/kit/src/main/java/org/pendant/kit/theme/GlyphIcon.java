package org.pendant.kit.theme;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.function.Supplier;
import javax.swing.Icon;
import javax.swing.UIManager;

/** A {@link Glyph} in the colour of its component's text, or in one of its own. */
public final class GlyphIcon implements Icon {
  private static final double GRID = 24;
  private static final float LINE = 1.8f;

  private final Glyph glyph;
  private final int size;
  private final Supplier<Color> color;

  /**
   * @param size of its sides, in pixels before scaling
   * @param color null, when asked, for the colour of the component
   */
  private GlyphIcon(Glyph glyph, int size, Supplier<Color> color) {
    this.glyph = glyph;
    this.size = size;
    this.color = color;
  }

  /** In the colour of the component's text. */
  public static GlyphIcon of(Glyph glyph, int size) {
    return new GlyphIcon(glyph, size, () -> null);
  }

  /** In a colour that may change with the theme. */
  public static GlyphIcon of(Glyph glyph, int size, Supplier<Color> color) {
    return new GlyphIcon(glyph, size, color);
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    Graphics2D painter = (Graphics2D) g.create();
    painter.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    painter.setRenderingHint(RenderingHints.KEY_STROKE_CONTROL, RenderingHints.VALUE_STROKE_PURE);
    painter.translate(x, y);
    painter.scale(getIconWidth() / GRID, getIconHeight() / GRID);
    painter.setColor(colorIn(c));
    painter.setStroke(new BasicStroke(LINE, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    glyph.strokes().forEach(painter::draw);
    glyph.fills().forEach(painter::fill);
    painter.dispose();
  }

  private Color colorIn(Component component) {
    if (!component.isEnabled()) {
      return UIManager.getColor("Label.disabledForeground");
    }
    Color own = color.get();
    return own == null ? component.getForeground() : own;
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(size);
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(size);
  }
}
