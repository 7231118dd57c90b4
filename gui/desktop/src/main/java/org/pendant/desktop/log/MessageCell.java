package org.pendant.desktop.log;

import java.awt.Color;
import java.awt.Component;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import javax.swing.JTable;
import javax.swing.UIManager;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.controller.message.LogEntry.Level;

/**
 * Message cell: a message in the table: errors and warnings whole, on as many lines as they need,
 * others on one; what is looked for is marked.
 */
@SuppressWarnings("serial") // never written to a stream
final class MessageCell extends DefaultTableCellRenderer {
  private static final int SIDE = 8;

  /** Longer texts do not fit on any screen; to measure them would take long. */
  private static final int MAX_CHARACTERS = 1000;

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

  /** Whether all of a message is shown, however long it is. */
  static boolean whole(LogLine line) {
    return line.level() != Level.INFO;
  }

  /** How the message is broken in a column of this width. */
  List<String> lines(LogLine line, FontMetrics metrics, int columnWidth) {
    String text = codeBeside ? line.withoutCode() : line.text();
    if (whole(line)) {
      return LineBreaker.lines(text, metrics::stringWidth, columnWidth - 2 * SIDE);
    }
    int end = text.indexOf('\n');
    String first = end < 0 ? text : text.substring(0, end).stripTrailing() + " \u2026";
    return List.of(cut(first, metrics, columnWidth - 2 * SIDE));
  }

  private static String cut(String text, FontMetrics metrics, int width) {
    String shown = text.substring(0, Math.min(text.length(), MAX_CHARACTERS));
    if (metrics.stringWidth(shown) <= width) {
      return shown;
    }
    int low = 0;
    int high = shown.length();
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (metrics.stringWidth(shown.substring(0, middle) + "\u2026") <= width) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return shown.substring(0, low) + "\u2026";
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
