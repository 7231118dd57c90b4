package org.pendant.desktop.whatif;

import static org.pendant.desktop.whatif.WhatIfTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.Graphics;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.UnaryOperator;
import javax.swing.DefaultCellEditor;
import javax.swing.Icon;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.table.TableCellEditor;
import javax.swing.table.TableCellRenderer;
import org.pendant.desktop.debug.CheckedField;
import org.pendant.kit.table.EditableTable;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.theme.Palette;

/** Variant table: the variants in rows, edited in place. */
@SuppressWarnings("serial") // never written to a stream
final class VariantTable extends EditableTable {
  /** Names and results may be cut down to so much; unscaled. */
  private static final int MIN_NAME = 90;

  private static final int MIN_RESULT = 130;

  private static final int ROW_SPACE = 12;

  /** Beside the text of a cell, so that it does not touch its neighbours; unscaled. */
  private static final int CELL_SPACE = 10;

  private final transient WhatIfPresenter presenter;
  private final VariantTableModel model;
  private boolean byHand;

  /**
   * The variants.
   *
   * @param refused says why something that is typed is refused
   */
  VariantTable(WhatIfPresenter presenter, VariantTableModel model, JLabel refused) {
    super(model);
    this.presenter = presenter;
    this.model = model;
    TableLook.apply(this, "whatif-table", text("variants"));
    TableLook.editInPlace(this);
    for (int i = 0; i < getColumnCount(); i++) {
      getColumnModel().getColumn(i).setCellRenderer(new Cell());
    }
    model.addTableModelListener(event -> fitColumns());
    edit(VariantTableModel.NAME, "whatif-name", refused, VariantRow::nameRefusal);
    edit(VariantTableModel.SPEED, "whatif-speed", refused, VariantRow::speedRefusal);
    edit(VariantTableModel.LOAD, "whatif-load", refused, VariantRow::loadRefusal);
    JComboBox<String> programs =
        new JComboBox<>(new String[] {VariantTableModel.AS_IT_RAN, VariantTableModel.AS_EDITED});
    programs.setName("whatif-program");
    programs.getAccessibleContext().setAccessibleName(text("programOfTheVariant"));
    getColumnModel()
        .getColumn(VariantTableModel.PROGRAM)
        .setCellEditor(new DefaultCellEditor(programs));
    key("DELETE", () -> presenter.remove(getSelectedRow()));
    key("INSERT", presenter::add);
  }

  private void edit(int column, String name, JLabel refused, UnaryOperator<String> refusal) {
    getColumnModel().getColumn(column).setCellEditor(new CheckedField(name, refused, refusal));
  }

  private void key(String stroke, Runnable run) {
    registerKeyboardAction(
        event -> run.run(), KeyStroke.getKeyStroke(stroke), JComponent.WHEN_FOCUSED);
  }

  /** Editing begins with what was typed, which is nothing where something is as it was. */
  @Override
  public Component prepareEditor(TableCellEditor editor, int row, int column) {
    Component component = super.prepareEditor(editor, row, column);
    if (component instanceof JTextField field) {
      field.setText(model.typed(row, column));
      field.selectAll();
    }
    return component;
  }

  /** In a narrow dock the last columns are scrolled to, rather than all cut off. */
  @Override
  public boolean getScrollableTracksViewportWidth() {
    return getParent() != null && getParent().getWidth() >= VariantColumns.least(widths());
  }

  /** Where people have to scroll, nothing is cut. */
  @Override
  public Dimension getPreferredSize() {
    boolean scrolls = getParent() != null && !getScrollableTracksViewportWidth();
    int width = scrolls ? VariantColumns.whole(widths()) : VariantColumns.least(widths());
    return new Dimension(width, super.getPreferredSize().height);
  }

  @Override
  public void updateUI() {
    super.updateUI();
    TableLook.fitRows(this, ROW_SPACE);
    byHand = false;
    revalidate();
  }

  /**
   * Columns that people have made wider or narrower stay so, and all do while somebody types: Swing
   * would give up what is typed.
   */
  @Override
  public void doLayout() {
    if (isEditing()) {
      return;
    }
    if (getTableHeader().getResizingColumn() != null) {
      byHand = true;
    }
    if (byHand) {
      super.doLayout();
      return;
    }
    int[] fitting = VariantColumns.fit(getWidth(), widths());
    for (int i = 0; i < fitting.length; i++) {
      getColumnModel().getColumn(i).setPreferredWidth(fitting[i]);
      getColumnModel().getColumn(i).setWidth(fitting[i]);
    }
  }

  @Override
  public void removeEditor() {
    super.removeEditor();
    fitColumns();
  }

  private void fitColumns() {
    if (!byHand) {
      resizeAndRepaint();
    }
  }

  private List<VariantColumns.Width> widths() {
    List<VariantColumns.Width> widths = new ArrayList<>();
    for (int column = 0; column < getColumnCount(); column++) {
      int content = content(column);
      widths.add(
          switch (column) {
            case VariantTableModel.NAME -> cut(content, MIN_NAME);
            case VariantTableModel.RESULT -> cut(content, MIN_RESULT);
            default -> new VariantColumns.Width(content, content);
          });
    }
    return widths;
  }

  private static VariantColumns.Width cut(int content, int least) {
    return new VariantColumns.Width(Math.min(content, UIScale.scale(least)), content);
  }

  /** The width by which title and cells of a column are whole. */
  private int content(int column) {
    TableCellRenderer titles = getTableHeader().getDefaultRenderer();
    int most =
        titles
            .getTableCellRendererComponent(this, getColumnName(column), false, false, -1, column)
            .getPreferredSize()
            .width;
    for (int row = 0; row < getRowCount(); row++) {
      most =
          Math.max(
              most,
              prepareRenderer(getCellRenderer(row, column), row, column).getPreferredSize().width);
    }
    return most + UIScale.scale(CELL_SPACE);
  }

  @Override
  public String getToolTipText(MouseEvent event) {
    int row = rowAtPoint(event.getPoint());
    int column = columnAtPoint(event.getPoint());
    if (row < 0 || column < 0) {
      return text("f2OrADoubleClickEdits");
    }
    String about = model.about(row, column);
    return about.isEmpty() ? null : about;
  }

  /** A cell; quiet where something is as it was, and bold where a variant is the best. */
  private final class Cell extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      List<VariantResult> results = presenter.results();
      boolean best =
          VariantTableModel.figure(column)
              .filter(figure -> ResultWords.best(figure, row, results))
              .isPresent();
      setFont(table.getFont().deriveFont(best ? Font.BOLD : Font.PLAIN));
      setIcon(column == VariantTableModel.NAME ? new Swatch(Palette.series(row)) : null);
      if (!selected) {
        setForeground(
            best
                ? Palette.ok()
                : column == VariantTableModel.RESULT && ResultWords.wrong(results.get(row))
                    ? Palette.error()
                    : model.untouched(row, column) ? Palette.quiet() : table.getForeground());
      }
      getAccessibleContext()
          .setAccessibleName(best ? text("theBest", value) : String.valueOf(value));
      return this;
    }
  }

  /** The colour of a variant's way, in a frame that sets it apart from that of a selected row. */
  record Swatch(Color color) implements Icon {
    private static final int WIDTH = 16;
    private static final int HEIGHT = 8;

    @Override
    public void paintIcon(Component on, Graphics graphics, int x, int y) {
      int frame = UIScale.scale(2);
      graphics.setColor(Palette.card());
      graphics.fillRect(x, y, getIconWidth(), getIconHeight());
      graphics.setColor(color);
      graphics.fillRect(
          x + frame, y + frame, getIconWidth() - 2 * frame, getIconHeight() - 2 * frame);
    }

    @Override
    public int getIconWidth() {
      return UIScale.scale(WIDTH);
    }

    @Override
    public int getIconHeight() {
      return UIScale.scale(HEIGHT);
    }
  }
}
