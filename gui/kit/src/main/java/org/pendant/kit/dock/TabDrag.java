package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import java.awt.Cursor;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.IntFunction;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;

/**
 * Tab drag: moves views to other sides or into windows of their own: by dragging their tabs, or by
 * a menu on them.
 */
final class TabDrag extends MouseAdapter {
  /** A shorter way (pixels) is a click with an unsteady hand. */
  private static final int SLACK = 10;

  private final DockFrame frame;
  private final IntFunction<String> idOfTab;
  private Point start = new Point();
  private int tab = -1;
  private boolean dragging;
  private final KeyEventDispatcher escape = this::escape;

  TabDrag(DockFrame frame, IntFunction<String> idOfTab) {
    this.frame = frame;
    this.idOfTab = idOfTab;
  }

  void attach(JTabbedPane tabs) {
    tabs.addMouseListener(this);
    tabs.addMouseMotionListener(this);
  }

  @Override
  public void mousePressed(MouseEvent event) {
    JTabbedPane tabs = (JTabbedPane) event.getSource();
    start = event.getPoint();
    tab = tabs.indexAtLocation(event.getX(), event.getY());
    showMenu(event);
  }

  @Override
  public void mouseDragged(MouseEvent event) {
    if (tab < 0 || !SwingUtilities.isLeftMouseButton(event)) {
      return;
    }
    if (!dragging && start.distance(event.getPoint()) > SLACK) {
      dragging = true;
      event.getComponent().setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
      KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(escape);
    }
    if (dragging && outside(event)) {
      frame.hideDrop();
    } else if (dragging) {
      frame.showDrop(inFrame(event));
    }
  }

  @Override
  public void mouseReleased(MouseEvent event) {
    int dropped = tab;
    boolean drop = dragging;
    event.getComponent().setCursor(null);
    end();
    if (!drop) {
      tab = dropped;
      showMenu(event);
      tab = -1;
      return;
    }
    Point point = inFrame(event);
    if (outside(event)) {
      frame.moveToWindow(idOfTab.apply(dropped), event.getLocationOnScreen());
    } else if (frame.component().contains(point)) {
      Side to = frame.sideAt(point);
      frame.move(idOfTab.apply(dropped), to, frame.indexAt(to, point));
    }
  }

  private void end() {
    KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(escape);
    frame.hideDrop();
    tab = -1;
    dragging = false;
  }

  /** Escape leaves the tab where it was. */
  private boolean escape(KeyEvent event) {
    if (event.getKeyCode() != KeyEvent.VK_ESCAPE) {
      return false;
    }
    end();
    return true;
  }

  private static boolean outside(MouseEvent event) {
    Window window = SwingUtilities.getWindowAncestor(event.getComponent());
    return !window.getBounds().contains(event.getLocationOnScreen());
  }

  private Point inFrame(MouseEvent event) {
    return SwingUtilities.convertPoint(event.getComponent(), event.getPoint(), frame.component());
  }

  private void showMenu(MouseEvent event) {
    if (event.isPopupTrigger() && tab >= 0) {
      menu(frame, idOfTab.apply(tab)).show(event.getComponent(), event.getX(), event.getY());
      tab = -1;
    }
  }

  /** Where a view may go. */
  static JPopupMenu menu(DockFrame frame, String id) {
    JPopupMenu menu = new JPopupMenu();
    for (Side side : Side.values()) {
      JMenuItem item = new JMenuItem(text("moveTo", side.title()));
      item.setName("move-" + id + "-" + side.word());
      item.setEnabled(frame.sideOf(id) != side);
      item.addActionListener(event -> frame.move(id, side));
      menu.add(item);
    }
    return menu;
  }
}
