package org.pendant.desktop.log;

import java.awt.Color;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.JTable;
import javax.swing.UIManager;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.controller.message.LogEntry.Level;

/**
 * Message cell: a message in the table: errors and warnings whole, on as many lines as they need,
 * others on a few; what is looked for is marked.
 */
@SuppressWarnings("serial") // never written to a stream
final class MessageCell extends DefaultTableCellRenderer {
  private static final int SIDE = 8;

  /** Of a message that is no error or warning; all of it is in its tool tip and below the table. */
  private static final int MAX_LINES_OF_INFORMATION = 4;

  private final Supplier<TextSearch> search;
  private boolean codeBeside;
  private List<String> lines = List.of();
  private boolean selected;

  MessageCell(Supplier<TextSearch> search) {
    this.search = search;
    // what programs write is no markup
    putClientProperty("html.disable", true);
  }

  /** Whether the code of a message stands in a column of its own. */
  void setCodeBeside(boolean beside) {
    codeBeside = beside;
  }

  /** How the message is broken in a column of this width. */
  List<String> lines(LogLine line, FontMetrics metrics, int columnWidth) {
    String text = codeBeside ? line.withoutCode() : line.text();
    int width = columnWidth - 2 * SIDE;
    if (line.level() != Level.INFO) {
      return LineBreaker.lines(text, metrics::stringWidth, width, LineBreaker.MAX_LINES);
    }
    int most = MAX_LINES_OF_INFORMATION;
    List<String> lines = LineBreaker.lines(text, metrics::stringWidth, width, most + 1);
    if (lines.size() <= most) {
      return lines;
    }
    List<String> first = new ArrayList<>(lines.subList(0, most));
    first.set(most - 1, cut(first.getLast() + " ", metrics, width));
    return first;
  }

  /** As much of a line as fits before an ellipsis. */
  private static String cut(String line, FontMetrics metrics, int width) {
    String kept = line;
    while (!kept.isEmpty() && metrics.stringWidth(kept + "\u2026") > width) {
      kept = kept.substring(0, kept.length() - 1);
    }
    return kept + "\u2026";
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean isSelected, boolean focused, int row, int column) {
    LogLine line = (LogLine) value;
    selected = isSelected;
    setFont(table.getFont());
    Color plain = line.level() == Level.INFO ? table.getForeground() : LogColors.of(line.level());
    setForeground(isSelected ? table.getSelectionForeground() : plain);
    setBackground(isSelected ? table.getSelectionBackground() : table.getBackground());
    lines =
        lines(
            line,
            table.getFontMetrics(table.getFont()),
            table.getColumnModel().getColumn(column).getWidth());
    setText(line.text());
    getAccessibleContext().setAccessibleName(line.text());
    return this;
  }

  @Override
  protected void paintComponent(Graphics g) {
    Graphics2D pen = (Graphics2D) g.create();
    if (UIManager.get("Component.desktopHints") instanceof Map<?, ?> hints) {
      pen.addRenderingHints(hints);
    }
    pen.setRenderingHint(
        RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
    pen.setColor(getBackground());
    pen.fillRect(0, 0, getWidth(), getHeight());
    pen.setFont(getFont());
    FontMetrics metrics = pen.getFontMetrics();
    int y = LogRows.PADDING;
    for (String each : lines) {
      if (!selected && !search.get().empty()) {
        mark(pen, metrics, each, y);
      }
      pen.setColor(getForeground());
      pen.drawString(each, SIDE, y + metrics.getAscent());
      y += metrics.getHeight();
    }
    pen.dispose();
  }

  private void mark(Graphics2D pen, FontMetrics metrics, String text, int y) {
    TextSearch wanted = search.get();
    pen.setColor(LogColors.mark());
    int at = wanted.find(text, 0);
    while (at >= 0) {
      int end = at + wanted.wanted().length();
      int x = SIDE + metrics.stringWidth(text.substring(0, at));
      int width = metrics.stringWidth(text.substring(at, end));
      pen.fillRoundRect(x - 1, y, width + 2, metrics.getHeight(), 4, 4);
      at = wanted.find(text, end);
    }
  }
}
