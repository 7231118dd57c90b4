package org.pendant.window;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.Optional;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import javax.swing.JList;
import javax.swing.JTree;

/** Finds rows of lists and trees by what they read. Only the dispatch thread calls it. */
final class Rows {
  private Rows() {}

  /**
   * Where a row is on the screen, brought into view: the first one that reads {@code text}, else
   * the first one with {@code text} in it.
   */
  static Rectangle place(Component component, String text) {
    return switch (component) {
      case JList<?> list -> place(list, text);
      case JTree tree -> place(tree, text);
      default -> throw new IllegalArgumentException(component.getName() + " has no rows");
    };
  }

  private static Rectangle place(JList<?> list, String text) {
    int row = find(list.getModel().getSize(), index -> Eyes.item(list, index), text);
    list.ensureIndexIsVisible(row);
    return onScreen(list, list.getCellBounds(row, row).intersection(list.getVisibleRect()));
  }

  private static Rectangle place(JTree tree, String text) {
    int row = find(tree.getRowCount(), index -> Eyes.node(tree, index), text);
    tree.scrollRowToVisible(row);
    return onScreen(tree, tree.getRowBounds(row).intersection(tree.getVisibleRect()));
  }

  private static int find(int count, IntFunction<String> words, String text) {
    Optional<Integer> whole =
        IntStream.range(0, count).boxed().filter(row -> words.apply(row).equals(text)).findFirst();
    return whole
        .or(
            () ->
                IntStream.range(0, count)
                    .boxed()
                    .filter(row -> words.apply(row).contains(text))
                    .findFirst())
        .orElseThrow(() -> new IllegalArgumentException("no row reads " + text));
  }

  private static Rectangle onScreen(Component component, Rectangle place) {
    Point corner = component.getLocationOnScreen();
    place.translate(corner.x, corner.y);
    return place;
  }
}
