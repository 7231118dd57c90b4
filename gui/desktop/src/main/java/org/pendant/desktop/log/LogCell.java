package org.pendant.desktop.log;

import java.awt.Component;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.kit.icon.SvgIcon;

/** Log cell: one of the table of messages, except of the messages themselves. */
@SuppressWarnings("serial") // never written to a stream
final class LogCell extends DefaultTableCellRenderer {
  private final LogColumn column;
  private final LogRuns runs;
  private final boolean compact;

  /**
   * A cell.
   *
   * @param runs say where messages come from
   * @param compact whether there is only room for a symbol
   */
  LogCell(LogColumn column, LogRuns runs, boolean compact) {
    this.runs = runs;
    this.column = column;
    this.compact = compact;
    boolean number = column == LogColumn.TIME || column == LogColumn.LINE;
    setHorizontalAlignment(number ? SwingConstants.TRAILING : SwingConstants.LEADING);
    setVerticalAlignment(SwingConstants.TOP);
    setIconTextGap(8);
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int row, int index) {
    LogLine line = (LogLine) value;
    String text = compact ? "" : column.text(line, runs);
    super.getTableCellRendererComponent(table, text, selected, focused, row, index);
    boolean severity = column == LogColumn.SEVERITY;
    boolean link = column == LogColumn.LINE && line.sourceLine().isPresent();
    SvgIcon icon = SeverityIcon.of(line.level());
    setIcon(!severity ? null : selected ? icon.in(table.getSelectionForeground()) : icon);
    getAccessibleContext().setAccessibleName(column.text(line, runs));
    setBorder(BorderFactory.createEmptyBorder(LogRows.PADDING, 8, 0, 8));
    setFont(link ? table.getFont().deriveFont(Font.BOLD) : table.getFont());
    if (!selected) {
      setForeground(link ? LogColors.link() : severity ? table.getForeground() : LogColors.quiet());
    }
    return this;
  }
}
