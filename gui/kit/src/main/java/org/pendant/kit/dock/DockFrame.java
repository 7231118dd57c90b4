package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JLayer;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.SwingUtilities;
import javax.swing.plaf.LayerUI;
import org.pendant.kit.layout.WindowBounds;
import org.pendant.kit.theme.Palette;

/**
 * Dock frame: the views, one in the main area, the others as tabs in docks around it or in windows
 * of their own.
 */
public final class DockFrame {
  private final DockPlan plan;
  private final Map<String, Dockable> views = new LinkedHashMap<>();
  private final Map<String, Side> home;
  private final Map<Side, DockPane> panes = new EnumMap<>(Side.class);
  private final Map<Side, Divider> dividers = new EnumMap<>(Side.class);
  private final List<Runnable> listeners = new ArrayList<>();
  private final List<Runnable> showListeners = new ArrayList<>();
  private final JPanel main = new JPanel(new BorderLayout());
  private final JPanel area = new JPanel(null);
  private final JLayer<JPanel> layer;
  private final Map<String, FloatingDock> windows = new LinkedHashMap<>();
  private final Consumer<JFrame> furnish;
  private final ViewFocus focus;
  private Optional<String> shown = Optional.empty();
  private Optional<Rectangle> drop = Optional.empty();

  /**
   * All views where the plan says.
   *
   * @param home where each view belongs at first
   * @param furnish gives each window of a view what all windows have: keys and a picture
   */
  public DockFrame(
      DockPlan plan,
      List<? extends Dockable> all,
      Map<String, Side> home,
      Consumer<JFrame> furnish) {
    this.plan = plan;
    this.furnish = furnish;
    this.home = new LinkedHashMap<>(home);
    all.forEach(view -> views.put(view.id(), view));
    focus = new ViewFocus(views.values());
    main.setName("main-area");
    main.add(nothing(), BorderLayout.CENTER);
    area.add(main);
    for (Side side : List.of(Side.LEFT, Side.RIGHT, Side.LOWER, Side.BOTTOM)) {
      DockPane pane = new DockPane(side, plan, views::get, this);
      Divider divider = new Divider(side, pixels -> resize(side, pixels));
      panes.put(side, pane);
      dividers.put(side, divider);
      area.add(pane);
      area.add(divider);
    }
    area.setLayout(new DockLayout(plan, main, panes, dividers));
    layer = new JLayer<>(area, new DropShade());
    layer.setName("dock-frame");
    layer.addHierarchyListener(event -> showWindows(false));
    fill();
  }

  /** What is shown. */
  public JComponent component() {
    return layer;
  }

  /**
   * Whether people can see any of the windows that the views are in.
   *
   * @param seen whether they can see a component
   */
  public boolean seen(Predicate<Component> seen) {
    return seen.test(layer)
        || plan.views(Side.WINDOW).stream().anyMatch(id -> seen.test(views.get(id).component()));
  }

  /** Every view. */
  public List<Dockable> views() {
    return List.copyOf(views.values());
  }

  /** Brings a view to the front, wherever it is, and gives it the focus. */
  public void show(String id) {
    reveal(id);
    List.copyOf(showListeners).forEach(Runnable::run);
    give(id);
  }

  /** Gives the focus to a view that is in sight. */
  void give(String id) {
    Dockable view = views.get(id);
    if (view != null) {
      // A tab is not visible, and takes no focus, before it is laid out.
      area.validate();
      Window window = SwingUtilities.getWindowAncestor(view.component());
      if (window != null && !window.isFocused() && window.isShowing()) {
        window.toFront();
      }
      focus.give(view);
    }
  }

  /** Brings a view to the front; the focus stays where it is. */
  public void reveal(String id) {
    plan.select(id);
    plan.sideOf(id).ifPresent(side -> plan.setCollapsed(side, false));
    fill();
  }

  /** The view in the main area. */
  public Optional<String> mainView() {
    return plan.selected(Side.MAIN);
  }

  /** Moves a view. */
  public void move(String id, Side to) {
    move(id, to, Integer.MAX_VALUE);
  }

  /**
   * Moves a view.
   *
   * @param index of its tab there, from 0; the last place if there are fewer
   */
  void move(String id, Side to, int index) {
    plan.move(id, to, index);
    fill();
    give(id);
  }

  /** Moves a view into a window of its own whose corner is at {@code corner} of the screen. */
  void moveToWindow(String id, Point corner) {
    plan.windowBounds(id)
        .or(() -> Optional.of(windowBounds(id)))
        .ifPresent(bounds -> plan.setWindowBounds(id, new Rectangle(corner, bounds.getSize())));
    move(id, Side.WINDOW);
  }

  /** Moves a view out of its window to where it was before. */
  void putBack(String id) {
    plan.putBack(id);
    fill();
    give(id);
  }

  /** Closes the windows of views; the plan keeps what was in them. */
  public void close() {
    windows.values().forEach(FloatingDock::close);
  }

  /** Where a view is. */
  public Side sideOf(String id) {
    return plan.sideOf(id).orElseThrow();
  }

  /** The places a view may go to. */
  public JPopupMenu moveMenu(String id) {
    return TabDrag.menu(this, id);
  }

  /** Shows only the tabs of a side, or all of it. */
  public void setCollapsed(Side side, boolean collapsed) {
    plan.setCollapsed(side, collapsed);
    fill();
  }

  /** Whether only the tabs of a side are shown. */
  public boolean collapsed(Side side) {
    return plan.collapsed(side);
  }

  /** Puts the windows of views above the main one: a start opens that last, and would hide them. */
  public void raiseWindows() {
    windows.values().forEach(FloatingDock::raise);
  }

  /** Changes between all of a side and only its tabs. */
  public void toggle(Side side) {
    setCollapsed(side, !plan.collapsed(side));
  }

  /** Puts everything where it belongs at first. */
  public void reset() {
    plan.reset(home);
    fill();
  }

  /** Tells {@code listener} when another view is in the main area. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Tells {@code listener} when a view is brought to the front, before the keys go there. */
  public void addShowListener(Runnable listener) {
    showListeners.add(listener);
  }

  /**
   * Shows what the plan says; what is there already stays as it is, with its focus. Keys that went
   * to a dock that is filled anew stay with the view that had them, or go to the main area where
   * that is hidden now: Swing would send them to the line beside it, which arrows move.
   */
  private void fill() {
    Optional<String> keys = viewWithKeys();
    Optional<String> front = plan.selected(Side.MAIN);
    if (!front.equals(shown)) {
      shown = front;
      main.removeAll();
    }
    windows.forEach(
        (id, window) -> {
          if (plan.sideOf(id).orElseThrow() != Side.WINDOW) {
            window.close();
          }
        });
    boolean lost = false;
    for (DockPane pane : panes.values()) {
      boolean within = ViewFocus.within(pane);
      lost |= pane.follow() && within;
    }
    showWindows(true);
    if (main.getComponentCount() == 0) {
      main.add(
          front.isPresent() ? views.get(front.get()).component() : nothing(), BorderLayout.CENTER);
      main.revalidate();
    }
    area.revalidate();
    area.repaint();
    if (lost) {
      keys.filter(this::inSight).or(this::mainView).ifPresent(this::give);
    }
    List.copyOf(listeners).forEach(Runnable::run);
  }

  private Optional<String> viewWithKeys() {
    return views.values().stream()
        .filter(view -> ViewFocus.within(view.component()))
        .map(Dockable::id)
        .findFirst();
  }

  /** Whether a view is the one in front where it is. */
  private boolean inSight(String id) {
    Side side = sideOf(id);
    return !plan.collapsed(side) && plan.selected(side).equals(Optional.of(id));
  }

  /**
   * Windows of views come with the one around them, not before it.
   *
   * @param takeKeys whether the keyboard goes to one that opens
   */
  private void showWindows(boolean takeKeys) {
    if (layer.isShowing()) {
      plan.views(Side.WINDOW).forEach(id -> showWindow(id, takeKeys));
    }
  }

  private void showWindow(String id, boolean takeKeys) {
    windows
        .computeIfAbsent(
            id, each -> new FloatingDock(views.get(each), plan, furnish, () -> putBack(each)))
        .open(windowBounds(id), takeKeys);
  }

  private Rectangle windowBounds(String id) {
    List<Rectangle> screens = WindowBounds.screens();
    return plan.windowBounds(id)
        .flatMap(bounds -> WindowBounds.within(bounds, screens))
        .orElseGet(
            () -> {
              Dimension size = new Dimension(area.getWidth() * 2 / 5, area.getHeight() / 2);
              Rectangle first = SwingUtilities.getWindowAncestor(area).getBounds();
              Rectangle shown = new Rectangle(area.getLocationOnScreen(), area.getSize());
              List<Rectangle> others =
                  windows.values().stream()
                      .map(FloatingDock::bounds)
                      .flatMap(Optional::stream)
                      .toList();
              return WindowBounds.second(first, shown, others, screens, size);
            });
  }

  private static JLabel nothing() {
    JLabel label = new JLabel(text("dragTheTabOfAPanel"), JLabel.CENTER);
    label.setForeground(Palette.quiet());
    return label;
  }

  private void resize(Side side, int pixels) {
    int moved = side == Side.LEFT ? pixels : -pixels;
    boolean lowerAlone = side == Side.RIGHT && plan.views(Side.RIGHT).isEmpty();
    DockPane pane = panes.get(lowerAlone ? Side.LOWER : side);
    boolean upright = side == Side.LEFT || side == Side.RIGHT;
    double size = upright ? pane.getWidth() : pane.getHeight();
    double whole = upright ? area.getWidth() : area.getHeight();
    plan.setShare(side, (size + UIScale.scale(DockLayout.DIVIDER) + moved) / Math.max(1, whole));
    area.revalidate();
  }

  // --- dragging

  Side sideAt(Point point) {
    for (Map.Entry<Side, DockPane> each : panes.entrySet()) {
      if (each.getValue().isVisible() && each.getValue().getBounds().contains(point)) {
        boolean below =
            each.getKey() == Side.RIGHT
                && plan.views(Side.LOWER).isEmpty()
                && point.y > area.getHeight() * 2 / 3;
        return below ? Side.LOWER : each.getKey();
      }
    }
    if (point.x < area.getWidth() / 5) {
      return Side.LEFT;
    }
    if (point.x > area.getWidth() * 4 / 5) {
      return Side.RIGHT;
    }
    return point.y > area.getHeight() * 2 / 3 ? Side.BOTTOM : Side.MAIN;
  }

  /** The place of a tab that is dropped at {@code point} of {@code side}. */
  int indexAt(Side side, Point point) {
    DockPane pane = panes.get(side);
    return pane == null
        ? Integer.MAX_VALUE
        : pane.indexAt(SwingUtilities.convertPoint(area, point, pane));
  }

  void showDrop(Point point) {
    drop = Optional.of(areaOf(sideAt(point)));
    layer.repaint();
  }

  void hideDrop() {
    drop = Optional.empty();
    layer.repaint();
  }

  private Rectangle areaOf(Side side) {
    if (side == Side.MAIN || side == Side.WINDOW) {
      return main.getBounds();
    }
    if (panes.get(side).isVisible()) {
      return panes.get(side).getBounds();
    }
    int width = area.getWidth();
    int height = area.getHeight();
    boolean upright = side == Side.LEFT || side == Side.RIGHT;
    int size = (int) Math.round(plan.share(side) * (upright ? width : height));
    return switch (side) {
      case LEFT -> new Rectangle(0, 0, size, height);
      case RIGHT -> new Rectangle(width - size, 0, size, height);
      case LOWER -> {
        Rectangle above = panes.get(Side.RIGHT).getBounds();
        yield new Rectangle(above.x, height - size, above.width, size);
      }
      case BOTTOM -> new Rectangle(main.getX(), height - size, main.getWidth(), size);
      case MAIN, WINDOW -> main.getBounds();
    };
  }

  /** Shows where a dragged view would go. */
  @SuppressWarnings("serial") // never written to a stream
  private final class DropShade extends LayerUI<JPanel> {
    @Override
    public void paint(Graphics g, JComponent c) {
      super.paint(g, c);
      if (drop.isPresent()) {
        Rectangle shade = drop.get();
        Color color = Palette.accent();
        g.setColor(new Color(color.getRed(), color.getGreen(), color.getBlue(), 60));
        g.fillRect(shade.x, shade.y, shade.width, shade.height);
        g.setColor(color);
        g.drawRect(shade.x, shade.y, shade.width - 1, shade.height - 1);
      }
    }
  }
}
