package org.pendant.desktop.program;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Point;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.LongConsumer;
import javax.swing.SwingUtilities;
import org.pendant.project.program.ProgramNode;

/**
 * Tree mouse: what a mouse does with a tree besides what it does with any list: breakpoints,
 * folding, and dragging the selected nodes.
 */
final class TreeMouse {
  private static final int DRAG_FROM = 5;

  private final TreeList list;
  private TreeDrag drag;
  private LongConsumer breakpoint = key -> {};
  private Runnable opened = () -> {};
  private Optional<Point> pressed = Optional.empty();

  /** Whether the press has changed nothing yet: a drag may follow. */
  private boolean deferred;

  TreeMouse(TreeList list) {
    this.list = list;
    drag = new TreeDrag(list, (cargo, spot) -> {});
  }

  /** Has nodes that are dragged put somewhere. */
  void setDrag(TreeDrag wanted) {
    drag = wanted;
  }

  /** Tells of clicks beside nodes. */
  void onBreakpoint(LongConsumer listener) {
    breakpoint = listener;
  }

  /** Tells when the user wants to change the selected node. */
  void onOpen(Runnable listener) {
    opened = listener;
  }

  /** Whether that was all; otherwise the list does what it does at a press. */
  boolean pressed(MouseEvent event) {
    pressed = Optional.empty();
    deferred = false;
    Optional<TreeRow> row = list.rowAt(event.getPoint());
    if (row.isEmpty() || !SwingUtilities.isLeftMouseButton(event)) {
      list.requestFocusInWindow();
      return true;
    }
    if (event.getX() < TreeCell.margin()) {
      breakpoint.accept(row.get().key());
      return true;
    }
    if (list.onTwisty(row.get(), event.getPoint())) {
      list.requestFocusInWindow();
      list.setFolded(row.get().key(), !row.get().folded());
      return true;
    }
    return pressedOn(row.get(), event);
  }

  private boolean pressedOn(TreeRow row, MouseEvent event) {
    pressed = Optional.of(event.getPoint());
    boolean selected = list.selected().contains(row.key());
    boolean plain = !event.isShiftDown() && !event.isControlDown();
    // Who drags several nodes begins on one of them, and who copies them holds Ctrl.
    deferred = selected && (event.isControlDown() || (plain && list.selected().size() > 1));
    if (deferred) {
      list.requestFocusInWindow();
    }
    if (event.getClickCount() == 2 && plain) {
      opened.run();
    }
    return deferred;
  }

  /** Whether that was all; otherwise the list does what it does at a release. */
  boolean released(MouseEvent event) {
    boolean taken = drag.active() || deferred;
    if (drag.active()) {
      drag.end();
    } else if (deferred) {
      pressed.flatMap(list::rowAt).ifPresent(row -> click(row, event));
    }
    pressed = Optional.empty();
    deferred = false;
    return taken;
  }

  /** What the press would have done. */
  private void click(TreeRow row, MouseEvent event) {
    if (event.isControlDown()) {
      int index = list.locationToIndex(event.getPoint());
      list.removeSelectionInterval(index, index);
    } else {
      list.select(row.key());
    }
  }

  void dragged(MouseEvent event) {
    boolean far =
        pressed
            .filter(from -> from.distance(event.getPoint()) > UIScale.scale(DRAG_FROM))
            .isPresent();
    if (far && !drag.active()) {
      List<ProgramNode> nodes =
          TreeEdits.tops(list.tree(), list.selected()).stream()
              .filter(TreeEdits::removable)
              .toList();
      if (!nodes.isEmpty()) {
        drag.begin(list, nodes, true);
      }
    }
    drag.move(event.getPoint(), (event.getModifiersEx() & InputEvent.CTRL_DOWN_MASK) != 0);
  }
}
