package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.function.Function;
import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import org.pendant.kit.icon.Glyph;

/** One dock: its views as tabs, or only the tabs while it is collapsed. */
@SuppressWarnings("serial") // never written to a stream
final class DockPane extends JPanel {
  private final Side side;
  private final transient DockPlan plan;
  private final transient Function<String, Dockable> viewOf;
  private final transient DockFrame frame;
  private final transient TabDrag drag;
  private DockTabs tabs = new DockTabs();
  private transient Shown shown = new Shown(List.of(), false, false);
  private boolean filling;

  /** What was filled in last. */
  private record Shown(List<String> views, boolean collapsed, boolean column) {}

  DockPane(Side side, DockPlan plan, Function<String, Dockable> viewOf, DockFrame frame) {
    super(new BorderLayout());
    this.side = side;
    this.plan = plan;
    this.viewOf = viewOf;
    this.frame = frame;
    drag = new TabDrag(frame, index -> plan.views(side).get(index));
    setName("dock-" + side.word());
  }

  /**
   * Shows what the plan says; the same tabs as before stay, and what is in them.
   *
   * @return whether there are others now
   */
  boolean follow() {
    Shown wanted = new Shown(plan.views(side), plan.collapsed(side), plan.collapsed(Side.RIGHT));
    boolean anew = !wanted.equals(shown);
    filling = true;
    if (!anew) {
      plan.selected(side)
          .filter(id -> !wanted.collapsed())
          .ifPresent(id -> tabs.setSelectedIndex(wanted.views().indexOf(id)));
    } else {
      shown = wanted;
      fill();
    }
    filling = false;
    return anew;
  }

  private void fill() {
    removeAll();
    tabs.removeAll();
    tabs = new DockTabs();
    tabs.setName("dock-tabs-" + side.word());
    tabs.getAccessibleContext().setAccessibleName(text("panelsAt", side.title()));
    if (plan.collapsed(side)) {
      fillStrip();
    } else {
      fillTabs();
    }
    drag.attach(tabs);
    add(tabs, BorderLayout.CENTER);
    revalidate();
    repaint();
  }

  private void fillTabs() {
    List<String> ids = plan.views(side);
    for (String id : ids) {
      Dockable view = viewOf.apply(id);
      tabs.addTab(view.title(), null, view.component(), text("dragToAnotherSideOrOut"));
    }
    plan.selected(side).ifPresent(id -> tabs.setSelectedIndex(ids.indexOf(id)));
    tabs.putClientProperty("JTabbedPane.trailingComponent", collapseButton());
    tabs.addChangeListener(
        event -> {
          if (!filling && tabs.getSelectedIndex() >= 0) {
            String id = plan.views(side).get(tabs.getSelectedIndex());
            plan.select(id);
            keepKeys(id);
          }
        });
  }

  /**
   * Keys that went to the view before go to the one that is chosen now, not to its first button,
   * which a space would press. Who goes from tab to tab by keys stays on the tabs.
   */
  private void keepKeys(String id) {
    if (ViewFocus.within(tabs) && !tabs.isFocusOwner()) {
      frame.give(id);
    }
  }

  /** The place of a tab that is dropped at {@code point}. */
  int indexAt(Point point) {
    int index = tabs.indexAtLocation(point.x - tabs.getX(), point.y - tabs.getY());
    return index < 0 ? tabs.getTabCount() : index;
  }

  private JPanel collapseButton() {
    Glyph glyph =
        switch (side) {
          case LEFT -> Glyph.LEFT;
          case RIGHT -> Glyph.RIGHT;
          case LOWER, BOTTOM, MAIN, WINDOW -> Glyph.DOWN;
        };
    JButton button = new JButton(glyph.icon(14));
    button.putClientProperty("JButton.buttonType", "toolBarButton");
    button.setName("dock-collapse-" + side.word());
    button.setToolTipText(text("showOnlyTheTabs"));
    button.getAccessibleContext().setAccessibleName(text("collapseTheDockAt", side.title()));
    button.addActionListener(event -> frame.setCollapsed(side, true));
    JPanel right = new JPanel(new BorderLayout());
    right.setOpaque(false);
    right.add(button, BorderLayout.EAST);
    return right;
  }

  private void fillStrip() {
    tabs.setTabPlacement(
        switch (side) {
          case LEFT -> JTabbedPane.LEFT;
          case RIGHT -> JTabbedPane.RIGHT;
          // Folded with the one above it, it is a strip at the edge as well.
          case LOWER -> plan.collapsed(Side.RIGHT) ? JTabbedPane.RIGHT : JTabbedPane.BOTTOM;
          case BOTTOM, MAIN, WINDOW -> JTabbedPane.BOTTOM;
        });
    tabs.putClientProperty("JTabbedPane.tabRotation", "auto");
    for (String id : plan.views(side)) {
      JPanel nothing = new JPanel();
      nothing.setPreferredSize(new Dimension(0, 0));
      tabs.addTab(viewOf.apply(id).title(), null, nothing, text("clickToShow"));
    }
    tabs.setSelectedIndex(-1);
    tabs.whenListed(index -> frame.show(plan.views(side).get(index)));
    tabs.addMouseListener(
        new MouseAdapter() {
          @Override
          public void mouseClicked(MouseEvent event) {
            int index = tabs.indexAtLocation(event.getX(), event.getY());
            if (index >= 0 && event.getButton() == MouseEvent.BUTTON1) {
              frame.show(plan.views(side).get(index));
            }
          }
        });
  }
}
