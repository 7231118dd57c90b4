package org.pendant.kit.table;

import java.awt.event.KeyEvent;
import java.util.EventObject;
import javax.swing.JTable;
import javax.swing.table.TableModel;

/**
 * Editable table: typing over a cell edits it, and shortcuts do not. Swing takes every key that the
 * table itself has no use for as something typed: with Ctrl, Alt or Meta, or as a function key, it
 * is an action of the window, which would not hear of it.
 */
@SuppressWarnings("serial") // never written to a stream
public class EditableTable extends JTable {
  /** A table of what a model has. */
  public EditableTable(TableModel model) {
    super(model);
  }

  @Override
  public boolean editCellAt(int row, int column, EventObject event) {
    return !isShortcut(event) && super.editCellAt(row, column, event);
  }

  private static boolean isShortcut(EventObject event) {
    return event instanceof KeyEvent key
        && (key.isControlDown() || key.isAltDown() || key.isMetaDown() || key.isActionKey());
  }
}
