package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Point;
import java.awt.event.MouseEvent;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** A menu that keys have opened below the pointer. */
final class StillItemTest {
  private static final Point POINTER = new Point(300, 200);

  private final JPopupMenu menu = new JPopupMenu();
  private final StillItem first = new StillItem("first", POINTER);
  private final StillItem second = new StillItem("second", POINTER);

  StillItemTest() {
    menu.add(first);
    menu.add(second);
    menu.setInvoker(new JPanel());
    MenuSelectionManager.defaultManager().setSelectedPath(new MenuElement[] {menu, first});
  }

  @AfterEach
  void close() {
    MenuSelectionManager.defaultManager().clearSelectedPath();
  }

  private void pointer(int kind, int x, int y) {
    second.dispatchEvent(new MouseEvent(second, kind, 0, 0, 5, 5, x, y, 0, false, 0));
  }

  @Test
  void aPointerThatWasThereBeforeChoosesNothing() {
    pointer(MouseEvent.MOUSE_ENTERED, 300, 200);
    assertTrue(first.isArmed());
    assertFalse(second.isArmed());
  }

  @Test
  void aPointerThatMovesChoosesWhatItIsOn() {
    pointer(MouseEvent.MOUSE_ENTERED, 300, 200);
    pointer(MouseEvent.MOUSE_MOVED, 301, 200);
    assertTrue(second.isArmed());
    assertFalse(first.isArmed());
  }
}
