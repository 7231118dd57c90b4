package org.pendant.desktop.debug;

import static org.pendant.desktop.debug.DebugTexts.text;

import java.awt.Color;
import java.awt.Component;
import java.awt.Font;
import javax.swing.BorderFactory;
import javax.swing.JTable;
import javax.swing.JTextArea;
import javax.swing.UIManager;
import javax.swing.table.DefaultTableCellRenderer;
import org.pendant.kit.icon.SvgIcon;
import org.pendant.kit.theme.Palette;

/** Value cell: paints the cells of a {@link ValueTable}. */
@SuppressWarnings("serial") // never written to a stream
final class ValueCell extends DefaultTableCellRenderer {
  private final JTextArea problem = new JTextArea();

  ValueCell() {
    problem.setLineWrap(true);
    problem.setWrapStyleWord(true);
  }

  @Override
  public void updateUI() {
    super.updateUI();
    if (problem != null) {
      problem.updateUI();
    }
  }

  /** How high a problem's text is, in a table of this width. */
  int problemHeight(ValueRow.Problem row, JTable table) {
    prepare(row, table);
    problem.setSize(Math.max(80, table.getWidth()), Short.MAX_VALUE);
    return problem.getPreferredSize().height;
  }

  private void prepare(ValueRow.Problem row, JTable table) {
    problem.setText(row.text());
    problem.setFont(table.getFont());
    problem.setBorder(
        BorderFactory.createEmptyBorder(
            2, DisclosureIcon.end(row.level()), 4, DisclosureIcon.end(0)));
  }

  /** How wide the cell of a name with so many letters is that is part of nothing. */
  int nameWidth(int letters, JTable table) {
    blank(table, false, 0);
    setFont(UIManager.getFont("monospaced.font"));
    setIcon(new DisclosureIcon(0, false, false));
    setText("m".repeat(letters));
    return getPreferredSize().width + table.getColumnModel().getColumnMargin();
  }

  /** A row that is no value, as wide as the table. */
  Component line(ValueRow row, JTable table, boolean selected) {
    if (row instanceof ValueRow.Problem text) {
      prepare(text, table);
      problem.setForeground(selected ? table.getSelectionForeground() : Palette.error());
      problem.setBackground(selected ? table.getSelectionBackground() : table.getBackground());
      return problem;
    }
    blank(table, selected, 0);
    quiet(selected);
    if (row instanceof ValueRow.Heading heading) {
      setText(heading.title());
      setFont(table.getFont().deriveFont(Font.BOLD));
    } else if (row instanceof ValueRow.More more) {
      setText(more.text());
      setIcon(new DisclosureIcon(more.level(), false, false));
    }
    return this;
  }

  private void blank(JTable table, boolean selected, int index) {
    super.getTableCellRendererComponent(table, "", selected, false, index, 0);
    setIcon(null);
    setToolTipText(null);
    if (!selected) {
      setBackground(table.getBackground());
      setForeground(table.getForeground());
    }
  }

  @Override
  public Component getTableCellRendererComponent(
      JTable table, Object value, boolean selected, boolean focused, int index, int column) {
    blank(table, selected, index);
    switch (((ValueTable) table).row(index)) {
      case ValueRow.Value shown ->
          show(shown, (ValueTable) table, table.convertColumnIndexToModel(column), selected);
      case ValueRow.Problem text -> setToolTipText(text.text());
      case ValueRow.Heading heading -> setToolTipText(heading.title());
      case ValueRow.More more -> setToolTipText(more.text());
    }
    return this;
  }

  private SvgIcon star(boolean favourite, boolean selected) {
    return selected ? Star.of(favourite).in(getForeground()) : Star.of(favourite);
  }

  private void quiet(boolean selected) {
    if (!selected) {
      setForeground(Palette.quiet());
    }
  }

  private void show(ValueRow.Value row, ValueTable table, int column, boolean selected) {
    switch (column) {
      case ValueTableModel.NAME -> {
        setFont(UIManager.getFont("monospaced.font"));
        setIcon(new DisclosureIcon(row.level(), row.hasParts(), row.unfolded()));
        setText(row.name());
        setToolTipText(row.name());
      }
      case ValueTableModel.STAR -> {
        setText("");
        setIcon(row.level() == 0 ? star(row.favourite(), selected) : null);
        setToolTipText(
            row.favourite()
                ? text("aFavouriteItComesFirstS")
                : text("makesItAFavouriteWhichComes"));
      }
      case ValueTableModel.VALUE -> {
        setFont(UIManager.getFont("monospaced.font"));
        String text = row.text();
        setText(text.isEmpty() ? "\u2013" : text.replaceAll("\\R", "\u21b5"));
        String why = table.whyFixed(row);
        setToolTipText(
            (text.isEmpty() ? text("itHasNoValueYet") : text)
                + (why.isEmpty() ? "" : " \u2013 " + why));
        mark(row, selected);
      }
      default -> {
        setText(row.kind());
        quiet(selected);
      }
    }
  }

  /**
   * A change at a stop is bold; one while the program runs only coloured, so that nothing jumps.
   */
  private void mark(ValueRow.Value row, boolean selected) {
    switch (row.change()) {
      case NONE -> {}
      case SINCE_STOP -> {
        setFont(getFont().deriveFont(Font.BOLD));
        setToolTipText(text("changedSinceTheLastStop", getToolTipText()));
        colour(Palette.warning(), selected);
      }
      case JUST_NOW -> colour(Palette.accent(), selected);
    }
  }

  private void colour(Color changed, boolean selected) {
    if (!selected) {
      setForeground(changed);
      setBackground(Palette.tint(changed, 0.14));
    }
  }
}
