package org.pendant.desktop.io;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import javax.swing.JLabel;
import org.pendant.kit.theme.Palette;

/**
 * A diamond beside an input that somebody forces; the place stays empty while nobody does.
 *
 * @param shown whether it is there
 */
record ForcedMark(boolean shown) implements Icon {
  private static final int SIZE = 9;
  private static final ForcedMark THERE = new ForcedMark(true);
  private static final ForcedMark AWAY = new ForcedMark(false);

  static ForcedMark of(boolean forced) {
    return forced ? THERE : AWAY;
  }

  /** Shows it beside a name. */
  static void show(JLabel label, boolean forced) {
    ForcedMark mark = of(forced);
    if (!mark.equals(label.getIcon())) {
      label.setIcon(mark);
      label.getAccessibleContext().setAccessibleDescription(forced ? "Forced" : "");
    }
  }

  @Override
  public int getIconWidth() {
    return UIScale.scale(SIZE);
  }

  @Override
  public int getIconHeight() {
    return UIScale.scale(SIZE);
  }

  @Override
  public void paintIcon(Component c, Graphics g, int x, int y) {
    if (shown) {
      Graphics2D pen = (Graphics2D) g.create();
      pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
      pen.translate(x, y);
      pen.scale(UIScale.scale(1f), UIScale.scale(1f));
      pen.setColor(Palette.warning());
      double half = SIZE / 2.0;
      Path2D diamond = new Path2D.Double();
      diamond.moveTo(half, 0);
      diamond.lineTo(SIZE, half);
      diamond.lineTo(half, SIZE);
      diamond.lineTo(0, half);
      diamond.closePath();
      pen.fill(diamond);
      pen.dispose();
    }
  }
}
