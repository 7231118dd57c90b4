package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.EventObject;
import javax.swing.AbstractAction;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import javax.swing.table.DefaultTableCellRenderer;
import javax.swing.text.JTextComponent;
import org.pendant.kit.table.EditableTable;

/**
 * Device signal table: {@link DeviceSignals} on the screen. Space or a click on it changes a level;
 * a number is typed over.
 */
@SuppressWarnings("serial") // never written to a stream
final class DeviceSignalTable extends EditableTable {
  private static final int MAX_ROWS = 8;
  private static final int VALUE_DIGITS = 12;

  private final DeviceSignals signals;

  DeviceSignalTable(String name, DeviceSignals signals) {
    super(signals);
    this.signals = signals;
    setName(name);
    getAccessibleContext().setAccessibleName(text("signals"));
    setDefaultRenderer(Object.class, new Cell());
    setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
    setRowSelectionAllowed(true);
    setColumnSelectionAllowed(false);
    setShowGrid(false);
    setTableHeader(null);
    setSurrendersFocusOnKeystroke(true);
    // Tab goes on to the next device, as from any other component
    setFocusTraversalKeys(KeyboardFocusManager.FORWARD_TRAVERSAL_KEYS, null);
    setFocusTraversalKeys(KeyboardFocusManager.BACKWARD_TRAVERSAL_KEYS, null);
    putClientProperty("terminateEditOnFocusLost", true);
    putClientProperty("FlatLaf.style", "cellMargins: 2,8,2,8");
    int width = VALUE_DIGITS * getFontMetrics(getFont()).charWidth('0');
    getColumnModel().getColumn(DeviceSignals.VALUE).setPreferredWidth(width);
    getColumnModel().getColumn(DeviceSignals.VALUE).setMaxWidth(width);
    bindToggle();
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
                signals.toggle(getSelectedRow());
              }
            });
    addMouseListener(
        new MouseAdapter() {
          @Override
          public void mousePressed(MouseEvent event) {
            if (SwingUtilities.isLeftMouseButton(event)
                && columnAtPoint(event.getPoint()) == DeviceSignals.VALUE) {
              signals.toggle(rowAtPoint(event.getPoint()));
            }
          }
        });
  }

  /** The value is what keys change, wherever the row was clicked. */
  @Override
  public void changeSelection(int row, int column, boolean toggle, boolean extend) {
    super.changeSelection(row, DeviceSignals.VALUE, toggle, extend);
  }

  /** What is typed takes the place of the value. */
  @Override
  public boolean editCellAt(int row, int column, EventObject event) {
    boolean edits = super.editCellAt(row, column, event);
    if (edits && getEditorComponent() instanceof JTextComponent field) {
      field.selectAll();
    }
    return edits;
  }

  @Override
  public Dimension getPreferredScrollableViewportSize() {
    int rows = Math.clamp(getRowCount(), 1, MAX_ROWS);
    return new Dimension(super.getPreferredScrollableViewportSize().width, rows * getRowHeight());
  }

  /** A level is a lamp or a switch, a number is a number. */
  private final class Cell extends DefaultTableCellRenderer {
    @Override
    public Component getTableCellRendererComponent(
        JTable table, Object value, boolean selected, boolean focused, int row, int column) {
      super.getTableCellRendererComponent(table, value, selected, focused, row, column);
      boolean level = column == DeviceSignals.VALUE && signals.digital(row);
      setHorizontalAlignment(
          column == DeviceSignals.VALUE ? SwingConstants.TRAILING : SwingConstants.LEADING);
      setIcon(null);
      if (level) {
        setText("");
        setIcon((signals.settable(row) ? LevelIcon.SWITCH : LevelIcon.LAMP).of(signals.high(row)));
      }
      getAccessibleContext()
          .setAccessibleName(
              signals.getValueAt(row, DeviceSignals.NAME)
                  + " is "
                  + signals.getValueAt(row, DeviceSignals.VALUE));
      return this;
    }
  }
}
