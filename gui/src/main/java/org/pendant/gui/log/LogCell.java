package org.pendant.gui.log;

import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.controller.message.LogEntry.Level;

/** A cell of the table of messages; what is looked for is marked in the messages. */
@SuppressWarnings("serial") // never written to a stream
final class LogCell extends DefaultTableCellRenderer {
  /** Longer texts do not fit on any screen; to measure them would take long. */
  private static final int MOST_CHARACTERS = 1000;

  private final LogPresenter presenter;
  private LogColumn column = LogColumn.MESSAGE;
  private Optional<TextSearch> marked = Optional.empty();

  LogCell(LogPresenter presenter) {
    this.presenter = presenter;
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int row, int index) {
    LogLine line = (LogLine) value;
    column = LogColumn.at(table.convertColumnIndexToModel(index));
    String text = column.text(line);
    super.getTableCellRendererComponent(
        table,
        text.substring(0, Math.min(text.length(), MOST_CHARACTERS)),
        selected,
        focused,
        row,
        index);
    boolean number = column == LogColumn.TIME || column == LogColumn.LINE;
    setHorizontalAlignment(number ? SwingConstants.TRAILING : SwingConstants.LEADING);
    setIcon(column == LogColumn.SEVERITY ? new SeverityIcon(line.level()) : null);
    setIconTextGap(8);
    setBorder(BorderFactory.createEmptyBorder(0, 8, 0, 8));
    marked = selected || column != LogColumn.MESSAGE ? Optional.empty() : search();
    setOpaque(marked.isEmpty());
    setFont(column == LogColumn.LINE ? table.getFont().deriveFont(Font.BOLD) : table.getFont());
    if (!selected) {
      setForeground(colorOf(table, line));
    }
    return this;
  }

  private Optional<TextSearch> search() {
    return Optional.of(presenter.search()).filter(search -> !search.empty());
  }

  private Color colorOf(JTable table, LogLine line) {
    if (column == LogColumn.LINE) {
      return LogColors.link();
    }
    if (column == LogColumn.MESSAGE) {
      return line.level() == Level.INFO ? table.getForeground() : LogColors.of(line.level());
    }
    return column == LogColumn.SEVERITY ? table.getForeground() : LogColors.quiet();
  }

  @Override
  protected void paintComponent(Graphics g) {
    marked.ifPresent(search -> mark(g, search));
    super.paintComponent(g);
  }

  private void mark(Graphics g, TextSearch search) {
    FontMetrics metrics = getFontMetrics(getFont());
    String text = ((JLabel) this).getText();
    g.setColor(getBackground());
    g.fillRect(0, 0, getWidth(), getHeight());
    g.setColor(LogColors.mark());
    int at = search.find(text, 0);
    while (at >= 0) {
      int end = at + search.wanted().length();
      int x = getInsets().left + metrics.stringWidth(text.substring(0, at));
      int width = metrics.stringWidth(text.substring(at, end));
      g.fillRoundRect(x - 1, 2, width + 2, getHeight() - 4, 4, 4);
      at = search.find(text, end);
    }
  }
}
