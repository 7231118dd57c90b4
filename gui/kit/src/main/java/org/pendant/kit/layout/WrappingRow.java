package org.pendant.kit.layout;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.EventQueue;
import java.awt.Insets;
import java.awt.LayoutManager;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;

/**
 * Components beside each other at their preferred sizes, centred in height; those that do not fit
 * begin a new row.
 */
public final class WrappingRow implements LayoutManager {
  private final int gap;
  private Dimension asked = new Dimension();

  /**
   * A row with space around and between the components.
   *
   * @param gap the space, in pixels before scaling
   */
  public WrappingRow(int gap) {
    this.gap = gap;
  }

  /**
   * Components that begin a new row together.
   *
   * @param gap between them, in pixels before scaling
   */
  public static JPanel together(int gap, Component... components) {
    JPanel together = new JPanel(new MigLayout("insets 0, gap " + UIScale.scale(gap)));
    together.setOpaque(false);
    for (Component each : components) {
      together.add(each);
    }
    return together;
  }

  private record Row(List<Component> components, int width, int height) {}

  private int gap() {
    return UIScale.scale(gap);
  }

  /** The rows in {@code width}; nothing in them is wider than that. */
  private List<Row> rows(Container parent, int width) {
    List<Row> rows = new ArrayList<>();
    List<Component> present = new ArrayList<>();
    int used = 0;
    int height = 0;
    for (Component each : parent.getComponents()) {
      Dimension wanted = each.getPreferredSize();
      if (!each.isVisible() || wanted.width == 0) {
        continue;
      }
      int taken = Math.min(wanted.width, width);
      if (!present.isEmpty() && used + gap() + taken > width) {
        rows.add(new Row(present, used, height));
        present = new ArrayList<>();
        used = 0;
        height = 0;
      }
      used += (present.isEmpty() ? 0 : gap()) + taken;
      height = Math.max(height, wanted.height);
      present.add(each);
    }
    if (!present.isEmpty()) {
      rows.add(new Row(present, used, height));
    }
    return rows;
  }

  private int innerWidth(Container parent) {
    Insets insets = parent.getInsets();
    return Math.max(0, parent.getWidth() - insets.left - insets.right - 2 * gap());
  }

  @Override
  public Dimension preferredLayoutSize(Container parent) {
    Insets insets = parent.getInsets();
    int width = parent.getWidth() > 0 ? innerWidth(parent) : Integer.MAX_VALUE;
    int widest = 0;
    int height = gap();
    for (Row row : rows(parent, width)) {
      widest = Math.max(widest, row.width());
      height += row.height() + gap();
    }
    return new Dimension(
        widest + 2 * gap() + insets.left + insets.right, height + insets.top + insets.bottom);
  }

  @Override
  public Dimension minimumLayoutSize(Container parent) {
    return new Dimension(0, preferredLayoutSize(parent).height);
  }

  @Override
  public void layoutContainer(Container parent) {
    Insets insets = parent.getInsets();
    int inner = innerWidth(parent);
    int y = insets.top + gap();
    for (Row row : rows(parent, inner)) {
      int x = insets.left + gap();
      for (Component each : row.components()) {
        Dimension size = each.getPreferredSize();
        int width = Math.min(size.width, inner);
        each.setBounds(x, y + (row.height() - size.height) / 2, width, size.height);
        x += width + gap();
      }
      y += row.height() + gap();
    }
    askForHeight(parent, y + insets.bottom);
  }

  /**
   * The height depends on the width, which is known only now: has the parent lay out again. It is
   * asked once for each width and height: there may be parents that cannot grant it.
   */
  private void askForHeight(Container parent, int height) {
    Dimension wanted = new Dimension(parent.getWidth(), height);
    if (height == parent.getHeight() || wanted.equals(asked)) {
      return;
    }
    asked = wanted;
    EventQueue.invokeLater(
        () -> {
          parent.invalidate();
          if (parent.getParent() instanceof JComponent around) {
            around.revalidate();
          }
        });
  }

  @Override
  public void addLayoutComponent(String name, Component component) {}

  @Override
  public void removeLayoutComponent(Component component) {}
}
