package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.util.List;
import javax.swing.JComponent;

/** Empty note: what an empty table says. */
final class EmptyNote {
  private static final int SIDE = 8;

  private EmptyNote() {}

  /**
   * Writes it in the middle of what is in sight.
   *
   * @param hidden whether there are messages that the filter hides
   */
  static void paint(JComponent on, Graphics g, boolean hidden) {
    String text =
        hidden ? text("theFiltersHideEveryMessage") : text("noMessagesYetWhatProgramsWrite");
    Graphics2D pen = (Graphics2D) g.create();
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setFont(on.getFont());
    pen.setColor(LogColors.quiet());
    FontMetrics metrics = pen.getFontMetrics();
    Rectangle sight = on.getVisibleRect();
    List<String> lines =
        LineBreaker.lines(
            text, metrics::stringWidth, sight.width - 2 * SIDE, LineBreaker.MAX_LINES);
    int y = sight.y + Math.max(SIDE, (sight.height - lines.size() * metrics.getHeight()) / 2);
    for (String each : lines) {
      y += metrics.getHeight();
      int left = (sight.width - metrics.stringWidth(each)) / 2;
      pen.drawString(each, sight.x + Math.max(SIDE, left), y);
    }
    pen.dispose();
  }
}
