package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import org.junit.jupiter.api.Test;

/** The list of what can be drawn, in no window. */
final class QuantityTreeTest {
  @Test
  void aNameThatIsCutHasAllItsWordsInItsToolTip() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "names are dragged, which needs a display");
    String name = "part on the tray at the left of the second feeder";
    ChartQuantities quantities =
        ChartQuantities.standard(signal -> signal.equals("digital-in-0") ? name : "");
    EventQueue.invokeAndWait(
        () -> {
          QuantityTree list = new QuantityTree(quantities, chosen -> {});
          JTree tree = find(list.component()).orElseThrow();
          for (int row = 0; row < tree.getRowCount(); row++) {
            tree.expandRow(row);
          }
          int cut = rowOf(tree, name);

          list.component().setSize(180, 400);
          layOut(list.component());
          assertTrue(toolTip(tree, cut).contains(name), toolTip(tree, cut));

          list.component().setSize(900, 400);
          layOut(list.component());
          assertEquals("Double-click, press Enter or drag on to a chart", toolTip(tree, cut));
        });
  }

  private static int rowOf(JTree tree, String words) {
    for (int row = 0; row < tree.getRowCount(); row++) {
      if (tree.getPathForRow(row).getLastPathComponent() instanceof DefaultMutableTreeNode node
          && node.getUserObject() instanceof ChartQuantity quantity
          && quantity.namedTitle().contains(words)) {
        return row;
      }
    }
    throw new AssertionError("no row with " + words);
  }

  private static String toolTip(JTree tree, int row) {
    Rectangle place = tree.getRowBounds(row);
    return tree.getToolTipText(
        new MouseEvent(tree, MouseEvent.MOUSE_MOVED, 0, 0, place.x + 5, place.y + 5, 0, false));
  }

  private static void layOut(Container in) {
    in.doLayout();
    Stream.of(in.getComponents())
        .filter(Container.class::isInstance)
        .forEach(each -> layOut((Container) each));
  }

  private static Optional<JTree> find(Component in) {
    if (in instanceof JTree tree) {
      return Optional.of(tree);
    }
    return in instanceof Container inner
        ? Stream.of(inner.getComponents()).flatMap(each -> find(each).stream()).findFirst()
        : Optional.empty();
  }
}
