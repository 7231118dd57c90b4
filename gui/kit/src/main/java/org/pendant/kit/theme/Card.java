package org.pendant.kit.theme;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.LayoutManager;
import java.awt.RenderingHints;
import javax.swing.JPanel;

/** A panel that lies on the window, with round corners. */
@SuppressWarnings("serial") // never written to a stream
public class Card extends JPanel {

  /** An empty card. */
  public Card(LayoutManager layout) {
    super(layout);
  }

  @Override
  public boolean isOpaque() {
    return false;
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D painter = (Graphics2D) g.create();
    painter.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    int arc = UIScale.scale(12);
    painter.setColor(Palette.card());
    painter.fillRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
    painter.setColor(Palette.line());
    painter.drawRoundRect(0, 0, getWidth() - 1, getHeight() - 1, arc, arc);
    painter.dispose();
  }
}
