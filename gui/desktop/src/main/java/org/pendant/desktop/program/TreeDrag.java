package org.pendant.desktop.program;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Cursor;
import java.awt.KeyEventDispatcher;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import org.pendant.kit.fault.Faults;
import org.pendant.project.program.ProgramNode;

/**
 * Tree drag: nodes on their way under the pointer, from the tree or from the palette. The pointer's
 * own component hands over where it is; the tree shows where the nodes would go.
 */
final class TreeDrag {
  private static final int SCROLL_MS = 40;
  private static final int EDGE = 26;

  private final TreeList list;
  private final BiConsumer<Cargo, Spot> drop;
  private final Timer scrolling = Faults.timer(SCROLL_MS, this::scroll);
  private final KeyEventDispatcher escape = this::key;
  private Optional<Cargo> cargo = Optional.empty();
  private Optional<Component> source = Optional.empty();
  private Point at = new Point();
  private boolean copies;

  /**
   * What is dragged.
   *
   * @param ofTree whether they are nodes of the tree, and leave their places unless they are copied
   */
  record Cargo(List<ProgramNode> nodes, boolean ofTree, boolean copied) {
    Cargo {
      nodes = List.copyOf(nodes);
    }

    boolean moved() {
      return ofTree && !copied;
    }
  }

  /**
   * A drag over a tree.
   *
   * @param drop puts nodes where the user has let them go
   */
  TreeDrag(TreeList list, BiConsumer<Cargo, Spot> drop) {
    this.list = list;
    this.drop = drop;
  }

  boolean active() {
    return cargo.isPresent();
  }

  /** Nodes are taken. */
  void begin(Component from, List<ProgramNode> nodes, boolean ofTree) {
    cargo = Optional.of(new Cargo(nodes, ofTree, false));
    source = Optional.of(from);
    from.setCursor(Cursor.getPredefinedCursor(Cursor.MOVE_CURSOR));
    KeyboardFocusManager.getCurrentKeyboardFocusManager().addKeyEventDispatcher(escape);
    scrolling.start();
  }

  /**
   * The pointer is elsewhere.
   *
   * @param point in the component where the drag began
   * @param copy whether the nodes also stay where they are
   */
  void move(Point point, boolean copy) {
    if (cargo.isPresent()) {
      at = SwingUtilities.convertPoint(source.orElseThrow(), point, list);
      copies = copy;
      show();
    }
  }

  private void show() {
    Cargo dragged = cargo.orElseThrow();
    cargo = Optional.of(new Cargo(dragged.nodes(), dragged.ofTree(), copies && dragged.ofTree()));
    Rectangle seen = list.getVisibleRect();
    boolean over =
        at.x >= seen.x
            && at.x < seen.x + seen.width
            && at.y >= seen.y - EDGE
            && at.y < seen.y + seen.height + EDGE;
    list.showDrop(over ? list.dropAt(at, cargo.get()) : Optional.empty(), cargo.get().copied());
  }

  /** The pointer is let go. */
  void end() {
    Optional<Cargo> dragged = cargo;
    Optional<DropSpots.Target> target = list.drop();
    cancel();
    if (dragged.isPresent() && target.filter(each -> each.refusal().isEmpty()).isPresent()) {
      drop.accept(dragged.get(), target.get().spot());
    } else {
      target.flatMap(DropSpots.Target::refusal).ifPresent(list::refuse);
    }
  }

  /** Nothing is dragged any more. */
  void cancel() {
    if (cargo.isPresent()) {
      cargo = Optional.empty();
      source.ifPresent(each -> each.setCursor(null));
      source = Optional.empty();
      scrolling.stop();
      KeyboardFocusManager.getCurrentKeyboardFocusManager().removeKeyEventDispatcher(escape);
      list.showDrop(Optional.empty(), false);
    }
  }

  private boolean key(KeyEvent event) {
    if (event.getID() == KeyEvent.KEY_PRESSED && event.getKeyCode() == KeyEvent.VK_ESCAPE) {
      cancel();
      return true;
    }
    return false;
  }

  private void scroll() {
    Rectangle seen = list.getVisibleRect();
    int edge = UIScale.scale(EDGE);
    int step = 0;
    if (at.y < seen.y + edge) {
      step = -list.getFixedCellHeight();
    } else if (at.y > seen.y + seen.height - edge) {
      step = list.getFixedCellHeight();
    }
    boolean over = at.x >= seen.x && at.x < seen.x + seen.width;
    if (step != 0 && over) {
      int y = step < 0 ? seen.y + step : seen.y + seen.height + step;
      list.scrollRectToVisible(new Rectangle(seen.x, y, 1, 1));
      int moved = list.getVisibleRect().y - seen.y;
      at = new Point(at.x, at.y + moved);
      show();
    }
  }
}
