package org.pendant.desktop.editor;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.geom.Path2D;
import javax.swing.Icon;
import org.pendant.kit.theme.Palette;

/** Marks the program that Run runs. */
enum RunIcon implements Icon {
  INSTANCE;

  private static final int SIZE = 12;

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
    Path2D triangle = new Path2D.Double();
    triangle.moveTo(x + 3, y + 1.5);
    triangle.lineTo(x + 10.5, y + 6);
    triangle.lineTo(x + 3, y + 10.5);
    triangle.closePath();
    pen.setColor(Palette.ok());
    pen.fill(triangle);
    pen.dispose();
  }
}
