package org.pendant.gui.log;

import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import javax.swing.JComponent;

/** What an empty table says. */
final class EmptyNote {
  private EmptyNote() {}

  /**
   * Writes it in the middle of what is in sight.
   *
   * @param hidden whether there are messages that the filter hides
   */
  static void paint(JComponent on, Graphics g, boolean hidden) {
    String text =
        hidden
            ? "The filters hide every message"
            : "No messages yet: what programs write with textmsg and what the controller says"
                + " appears here";
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setFont(on.getFont());
    pen.setColor(LogColors.quiet());
    FontMetrics metrics = pen.getFontMetrics();
    Rectangle sight = on.getVisibleRect();
    pen.drawString(
        text,
        Math.max(8, sight.x + (sight.width - metrics.stringWidth(text)) / 2),
        sight.y + sight.height / 2);
    pen.dispose();
  }
}
