package org.pendant.kit.table;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.table.DefaultTableModel;
import org.junit.jupiter.api.Test;

final class EditableTableTest {
  private final EditableTable table = new EditableTable(new DefaultTableModel(1, 1));

  @Test
  void typingEditsACell() throws Exception {
    assertTrue(edits(KeyEvent.VK_5, 0, '5'));
    assertTrue(edits(KeyEvent.VK_P, InputEvent.SHIFT_DOWN_MASK, 'P'));
    EventQueue.invokeAndWait(() -> assertTrue(table.editCellAt(0, 0)));
  }

  @Test
  void shortcutsOfTheWindowDoNot() throws Exception {
    int both = InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK;
    assertFalse(edits(KeyEvent.VK_P, both, 'P'));
    assertFalse(edits(KeyEvent.VK_3, InputEvent.ALT_DOWN_MASK, '3'));
    assertFalse(edits(KeyEvent.VK_S, InputEvent.META_DOWN_MASK, 's'));
    assertFalse(edits(KeyEvent.VK_F5, 0, KeyEvent.CHAR_UNDEFINED));
  }

  private boolean edits(int code, int modifiers, char typed) throws Exception {
    KeyEvent key = new KeyEvent(table, KeyEvent.KEY_PRESSED, 0, modifiers, code, typed);
    boolean[] editing = new boolean[1];
    EventQueue.invokeAndWait(
        () -> {
          editing[0] = table.editCellAt(0, 0, key);
          table.removeEditor();
        });
    return editing[0];
  }
}
