package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BasicStroke;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.pendant.kit.theme.Palette;

/**
 * Drop mark: draws where nodes would go that are dragged, or why they cannot go there.
 *
 * @param copied whether they also stay where they are
 */
record DropMark(TreeList list, DropSpots.Target target, boolean copied) {
  private static final Pattern WORDS = Pattern.compile(" ");

  /** Draws it; {@code pen} is not used any more afterwards. */
  void paint(Graphics2D pen) {
    pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
    int height = list.getFixedCellHeight();
    int width = list.getWidth();
    pen.setColor(target.refusal().isPresent() ? Palette.error() : Palette.accent());
    pen.setStroke(new BasicStroke(UIScale.scale(2f)));
    int x = list.contentX(target.depth());
    int y = target.line() * height;
    if (target.into() >= 0) {
      pen.drawRoundRect(x - 2, y + 1, width - x - 2, height - 2, 6, 6);
    } else {
      int line = Math.min(y, list.getModel().getSize() * height - 1);
      int dot = UIScale.scale(6);
      pen.fillOval(x - dot / 2, line - dot / 2, dot, dot);
      pen.drawLine(x, line, width, line);
    }
    String text = target.refusal().orElse(copied ? text("copyHere") : "");
    if (!text.isEmpty()) {
      paintPlate(pen, text, y);
    }
    pen.dispose();
  }

  private void paintPlate(Graphics2D pen, String text, int y) {
    FontMetrics metrics = pen.getFontMetrics();
    Rectangle seen = list.getVisibleRect();
    int pad = UIScale.scale(5);
    List<String> lines = lines(text, metrics, seen.width - 4 * pad);
    int height = lines.size() * metrics.getHeight() + 2 * pad;
    int widest = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
    int width = Math.min(seen.width - 2 * pad, widest + 2 * pad);
    int top = y + 2 * list.getFixedCellHeight();
    if (top + height > seen.y + seen.height) {
      top = Math.max(seen.y, y - list.getFixedCellHeight() - height);
    }
    int x = seen.x + pad;
    pen.setColor(Palette.card());
    pen.fillRoundRect(x, top, width, height, 8, 8);
    pen.setColor(Palette.line());
    pen.setStroke(new BasicStroke(1));
    pen.drawRoundRect(x, top, width, height, 8, 8);
    pen.setColor(list.getForeground());
    int base = top + pad + metrics.getAscent();
    for (String line : lines) {
      pen.drawString(line, x + pad, base);
      base += metrics.getHeight();
    }
  }

  /** A text in lines that are not wider than there is room for. */
  private static List<String> lines(String text, FontMetrics metrics, int room) {
    List<String> lines = new ArrayList<>();
    String line = "";
    for (String word : WORDS.splitAsStream(text).toList()) {
      String longer = line.isEmpty() ? word : line + " " + word;
      if (!line.isEmpty() && metrics.stringWidth(longer) > room) {
        lines.add(line);
        longer = word;
      }
      line = longer;
    }
    lines.add(line);
    return lines;
  }
}
