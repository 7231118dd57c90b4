package org.pendant.desktop.editor;

import java.awt.Point;
import java.awt.event.MouseEvent;
import javax.swing.JMenuItem;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;

/** An item that a pointer does not choose which was there before the menu opened below it. */
@SuppressWarnings("serial") // never written to a stream
final class StillItem extends JMenuItem {
  private final transient Point pointer;

  StillItem(String title, Point pointer) {
    super(title);
    this.pointer = pointer;
  }

  @Override
  protected void processMouseEvent(MouseEvent event) {
    if (event.getID() != MouseEvent.MOUSE_ENTERED || !event.getLocationOnScreen().equals(pointer)) {
      super.processMouseEvent(event);
    }
  }

  @Override
  protected void processMouseMotionEvent(MouseEvent event) {
    super.processMouseMotionEvent(event);
    if (!isArmed() && !event.getLocationOnScreen().equals(pointer)) {
      MenuSelectionManager.defaultManager()
          .setSelectedPath(new MenuElement[] {(MenuElement) getParent(), this});
    }
  }
}
