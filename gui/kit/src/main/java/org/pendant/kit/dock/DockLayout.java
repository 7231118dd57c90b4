package org.pendant.kit.dock;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import java.util.EnumMap;
import java.util.Map;
import java.util.function.Consumer;

/** Dock layout: places the main area, the docks around it and the dividers between them. */
final class DockLayout implements LayoutManager {
  /** The main area keeps this width and height, in pixels before scaling, as long as it can. */
  private static final int MAIN_WIDTH = 280;

  private static final int MAIN_HEIGHT = 260;

  /** Below this a panel at the bottom has its bar and next to nothing else; in the same. */
  private static final int USEFUL_HEIGHT = 208;

  /** Thickness of the line between a dock and what is beside it, in pixels before scaling. */
  static final int DIVIDER = 6;

  private final DockPlan plan;
  private final Component main;
  private final Map<Side, DockPane> panes;
  private final Map<Side, Divider> dividers;

  DockLayout(
      DockPlan plan, Component main, Map<Side, DockPane> panes, Map<Side, Divider> dividers) {
    this.plan = plan;
    this.main = main;
    this.panes = new EnumMap<>(panes);
    this.dividers = new EnumMap<>(dividers);
  }

  @Override
  public void layoutContainer(Container parent) {
    int width = parent.getWidth();
    int height = parent.getHeight();
    int room = width - UIScale.scale(MAIN_WIDTH);
    int right = Math.max(thickness(Side.RIGHT, width, room), columnOfLower(width, room));
    int left = thickness(Side.LEFT, width, room - right);
    int bottom = thickness(Side.BOTTOM, height, height - UIScale.scale(MAIN_HEIGHT));
    int lower = lower(height);
    int inner = width - left - right;
    int gap = UIScale.scale(DIVIDER);

    place(Side.LEFT, left, r -> r.setBounds(0, 0, left, height), gap, height);
    if (plan.views(Side.RIGHT).isEmpty() && lower > 0 && !plan.collapsed(Side.RIGHT)) {
      placeLowerAlone(new Rectangle(width - right, 0, right, height), gap);
    } else {
      placeAtRight(new Rectangle(width - right, 0, right, height), lower, gap);
    }
    place(Side.BOTTOM, bottom, r -> r.setBounds(left, height - bottom, inner, bottom), gap, height);
    main.setBounds(left, 0, inner, height - bottom);
  }

  private void placeAtRight(Rectangle column, int lower, int gap) {
    int upper = plan.views(Side.RIGHT).isEmpty() ? 0 : column.width;
    place(
        Side.RIGHT,
        upper,
        r -> r.setBounds(column.x, 0, column.width, column.height - lower),
        gap,
        column.height);
    int inset = plan.collapsed(Side.RIGHT) || upper == 0 ? 0 : gap;
    place(
        Side.LOWER,
        lower,
        r -> r.setBounds(column.x + inset, column.height - lower, column.width - inset, lower),
        gap,
        column.height);
  }

  /** Beside a lower dock that has the whole column is the line by which the column gets wider. */
  private void placeLowerAlone(Rectangle column, int gap) {
    panes.get(Side.RIGHT).setVisible(false);
    dividers.get(Side.LOWER).setVisible(false);
    dividers.get(Side.RIGHT).setVisible(true);
    dividers.get(Side.RIGHT).setBounds(column.x, 0, gap, column.height);
    panes.get(Side.LOWER).setVisible(true);
    panes.get(Side.LOWER).setBounds(column.x + gap, 0, column.width - gap, column.height);
  }

  /** The width of the column at the right where only its lower dock has views. */
  private int columnOfLower(int width, int room) {
    if (plan.views(Side.LOWER).isEmpty() || !plan.views(Side.RIGHT).isEmpty()) {
      return 0;
    }
    return plan.collapsed(Side.RIGHT)
        ? panes.get(Side.LOWER).getPreferredSize().width
        : open(Side.RIGHT, width, room);
  }

  /** The height of the lower dock at the right; all of it when it is alone there. */
  private int lower(int height) {
    if (plan.views(Side.LOWER).isEmpty()) {
      return 0;
    }
    if (plan.views(Side.RIGHT).isEmpty()) {
      return height;
    }
    if (plan.collapsed(Side.RIGHT)) {
      return height / 2;
    }
    return thickness(Side.LOWER, height, height - UIScale.scale(DockPlan.SMALLEST));
  }

  /** How much a dock takes of {@code whole} with its divider; 0 for an empty one. */
  private int thickness(Side side, int whole, int room) {
    if (plan.views(side).isEmpty()) {
      return 0;
    }
    if (plan.collapsed(side)) {
      Dimension strip = panes.get(side).getPreferredSize();
      return side == Side.BOTTOM || side == Side.LOWER ? strip.height : strip.width;
    }
    return open(side, whole, room);
  }

  private int open(Side side, int whole, int room) {
    int smallest = UIScale.scale(DockPlan.SMALLEST);
    int wanted = (int) Math.round(plan.share(side) * whole);
    int useful = side == Side.BOTTOM ? UIScale.scale(USEFUL_HEIGHT) : smallest;
    return Math.max(smallest, Math.min(Math.max(wanted, useful), room));
  }

  private void place(Side side, int thickness, Consumer<Rectangle> bounds, int gap, int height) {
    Rectangle area = new Rectangle();
    bounds.accept(area);
    boolean divided = thickness > 0 && !plan.collapsed(side);
    panes.get(side).setVisible(thickness > 0);
    dividers.get(side).setVisible(divided);
    if (!divided) {
      panes.get(side).setBounds(area);
      return;
    }
    Rectangle line = new Rectangle(area);
    switch (side) {
      case LEFT -> {
        line.x = area.x + area.width - gap;
        line.width = gap;
        area.width -= gap;
      }
      case RIGHT -> {
        // one line along both docks there; to move it twice would have all beside it drawn again
        line.setBounds(area.x, 0, gap, height);
        area.x += gap;
        area.width -= gap;
      }
      case LOWER, BOTTOM -> {
        line.height = gap;
        area.y += gap;
        area.height -= gap;
      }
      case MAIN, WINDOW -> throw new IllegalArgumentException(side.title() + " has no divider");
    }
    panes.get(side).setBounds(area);
    dividers.get(side).setBounds(line);
  }

  @Override
  public Dimension preferredLayoutSize(Container parent) {
    return UIScale.scale(new Dimension(1000, 560));
  }

  @Override
  public Dimension minimumLayoutSize(Container parent) {
    return UIScale.scale(new Dimension(MAIN_WIDTH, MAIN_HEIGHT));
  }

  @Override
  public void addLayoutComponent(String name, Component component) {}

  @Override
  public void removeLayoutComponent(Component component) {}
}
