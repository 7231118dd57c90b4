package org.pendant.desktop.plot;

import java.awt.BorderLayout;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.List;
import java.util.function.Consumer;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** Plot pane: the quantities at the left, the charts and their bar at the right. */
final class PlotPane {
  private final ChartStack stack;
  private final PlotBar bar;
  private final QuantityTree tree;
  private final JSplitPane split;
  private int treeWidth;
  private int placed;

  /**
   * A pane for what a presenter draws.
   *
   * @param changed runs when people have changed how it is drawn
   * @param add draws quantities that people choose
   * @param export runs when people want to keep what is drawn
   */
  PlotPane(
      PlotPresenter presenter,
      Runnable changed,
      Consumer<List<ChartQuantity>> add,
      Runnable export) {
    stack = new ChartStack(presenter, changed);
    bar = new PlotBar(presenter, changed, export);
    tree = new QuantityTree(presenter.quantities(), add);
    JPanel right = new JPanel(new BorderLayout());
    right.add(bar.component(), BorderLayout.NORTH);
    right.add(stack, BorderLayout.CENTER);
    split = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, tree.component(), right);
    split.setBorder(BorderFactory.createEmptyBorder());
    split.setName("plot-split");
    treeWidth = tree.component().getPreferredSize().width;
    placed = treeWidth;
    split.setDividerLocation(placed);
    split.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            place();
          }
        });
  }

  /** The charts have most of a narrow screen, until people move the divider. */
  private void place() {
    if (split.getDividerLocation() != placed) {
      treeWidth = split.getDividerLocation();
    }
    placed = Math.min(treeWidth, Math.max(split.getWidth() * 3 / 10, 1));
    split.setDividerLocation(placed);
  }

  JComponent component() {
    return split;
  }

  ChartStack stack() {
    return stack;
  }

  QuantityTree tree() {
    return tree;
  }

  /** Shows what has changed. */
  void refresh() {
    bar.refresh();
    stack.refresh();
  }
}
