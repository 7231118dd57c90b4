package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.Component;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.DefaultCellEditor;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.SwingUtilities;
import org.pendant.kit.layout.Typed;
import org.pendant.kit.table.EditableTable;
import org.pendant.kit.table.TableLook;
import org.pendant.kit.text.Messages;

/**
 * Memory table: a {@link MemoryList} on the screen. Space or a click on it changes a level; a
 * number is typed over, or edited with F2 or a double click, as names are.
 */
@SuppressWarnings("serial") // never written to a stream
final class MemoryTable extends EditableTable {
  private static final int NUMBER_DIGITS = 6;
  private static final int VALUE_DIGITS = 12;

  private final MemoryTableModel model;

  /**
   * A table without rows.
   *
   * @param problem tells what is wrong with what is typed; empty when nothing is
   */
  MemoryTable(String name, MemoryList list, Consumer<String> problem) {
    this(name, new MemoryTableModel(list, problem), list, problem);
  }

  private MemoryTable(
      String name, MemoryTableModel model, MemoryList list, Consumer<String> problem) {
    super(model);
    this.model = model;
    TableLook.apply(this, name, Messages.shown(list.memory().title()));
    setDefaultRenderer(Object.class, new MemoryCell());
    setDefaultEditor(Object.class, new Editor(name, list, problem));
    setCellSelectionEnabled(true);
    setSurrendersFocusOnKeystroke(true);
    putClientProperty("FlatLaf.style", "cellMargins: 2,8,2,8");
    getTableHeader().putClientProperty("FlatLaf.style", "cellMargins: 2,8,2,8");
    putClientProperty("terminateEditOnFocusLost", true);
    fit(MemoryTableModel.NUMBER, NUMBER_DIGITS);
    fit(MemoryTableModel.VALUE, list.memory().levels() ? NUMBER_DIGITS + 1 : VALUE_DIGITS);
    if (list.memory().levels()) {
      bindToggle();
    }
  }

  private void fit(int column, int digits) {
    String title = "  " + getColumnName(column) + "  00";
    int width =
        Math.max(
            digits * getFontMetrics(getFont()).charWidth('0'),
            getTableHeader().getFontMetrics(getTableHeader().getFont()).stringWidth(title));
    getColumnModel().getColumn(column).setPreferredWidth(width);
    getColumnModel().getColumn(column).setMinWidth(width);
    getColumnModel().getColumn(column).setMaxWidth(2 * width);
  }

  private void bindToggle() {
    getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
        .put(KeyStroke.getKeyStroke(KeyEvent.VK_SPACE, 0), "toggle");
    getActionMap()
        .put(
            "toggle",
            new AbstractAction() {
              @Override
              public void actionPerformed(ActionEvent event) {
                toggle(getSelectedRow());
              }
            });
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)
                && columnAtPoint(event.getPoint()) == MemoryTableModel.VALUE) {
              toggle(rowAtPoint(event.getPoint()));
            }
          }
        });
  }

  private void toggle(int row) {
    if (row >= 0 && row < getRowCount() && model.list().settable()) {
      model.list().toggle(model.index(row));
      model.refresh();
    }
  }

  /** Shows the newest values; answers whether the rows are others than before. */
  boolean showNewest() {
    if (isEditing()) {
      return false;
    }
    int row = getSelectedRow();
    int column = getSelectedColumn();
    int index = row < 0 ? -1 : model.index(row);
    boolean changed = model.refresh();
    if (changed && index >= 0) {
      int now = model.list().shown().indexOf(index);
      if (now >= 0) {
        changeSelection(now, Math.max(0, column), false, false);
      }
    }
    return changed;
  }

  /** Keeps what is typed until it is right. */
  private static final class Editor extends DefaultCellEditor {
    private final transient MemoryList list;
    private final transient Consumer<String> problem;
    private final JTextField field;
    private int index;
    private boolean naming;

    Editor(String name, MemoryList list, Consumer<String> problem) {
      super(new JTextField());
      this.list = list;
      this.problem = problem;
      field = (JTextField) getComponent();
      field.setName(name + "-field");
      field.getDocument().addDocumentListener(new Typed(() -> tell("")));
      setClickCountToStart(2);
    }

    private void tell(String text) {
      problem.accept(text);
      field.putClientProperty("JComponent.outline", text.isEmpty() ? null : "error");
    }

    @Override
    public Component getTableCellEditorComponent(
        JTable table, Object value, boolean selected, int row, int column) {
      Component component = super.getTableCellEditorComponent(table, value, selected, row, column);
      index = ((MemoryTableModel) table.getModel()).index(row);
      naming = column == MemoryTableModel.NAME;
      field
          .getAccessibleContext()
          .setAccessibleName(
              text(naming ? "yourNameFor" : "valueOfRegister", list.memory().name(index)));
      field.selectAll();
      tell("");
      return component;
    }

    @Override
    public boolean stopCellEditing() {
      if (!naming) {
        try {
          list.check(field.getText());
        } catch (IllegalArgumentException e) {
          tell(Messages.shown(e.getMessage()));
          return false;
        }
      }
      tell("");
      return super.stopCellEditing();
    }

    @Override
    public void cancelCellEditing() {
      tell("");
      super.cancelCellEditing();
    }
  }
}
