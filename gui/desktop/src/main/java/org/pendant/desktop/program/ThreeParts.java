package org.pendant.desktop.program;

import static org.pendant.desktop.program.ProgramViewTexts.text;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.util.OptionalInt;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import org.pendant.kit.settings.Settings;

/**
 * Layout of three parts: palette, tree and tabs beside each other. Where there is no room for all
 * three, the palette is one of the tabs.
 */
@SuppressWarnings("serial") // never written to a stream
final class ThreeParts extends JPanel {
  private static final int NARROW = 700;
  private static final int MIN_TABS = 240;
  private static final int MIN_TREE = 150;

  /** The share of all three that the tree has at first: names of nodes are long. */
  private static final double USUAL_TREE = 0.4;

  private static final String TREE = "program.tree-share";
  private static final String PALETTE = "program.palette-width";
  private static final int USUAL_PALETTE = 150;

  private final JComponent palette;
  private final JTabbedPane tabs;
  private final JSplitPane inner;
  private final JSplitPane outer;
  private final transient Settings settings;
  private boolean narrow;
  private boolean arranging;

  ThreeParts(JComponent palette, JComponent tree, JTabbedPane tabs, Settings settings) {
    super(new BorderLayout());
    this.palette = palette;
    this.tabs = tabs;
    this.settings = settings;
    inner = split("program-tree-width", tree, tabs);
    outer = split("program-palette-width", palette, inner);
    remember(
        inner,
        () -> settings.put(TREE, String.valueOf(1000 * inner.getDividerLocation() / getWidth())));
    remember(
        outer,
        () -> settings.put(PALETTE, String.valueOf(UIScale.unscale(outer.getDividerLocation()))));
    outer.setDividerLocation(paletteWidth());
    add(outer);
  }

  private static JSplitPane split(String name, JComponent left, JComponent right) {
    JSplitPane split = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, left, right);
    split.setName(name);
    split.setBorder(BorderFactory.createEmptyBorder());
    split.setContinuousLayout(true);
    return split;
  }

  private void remember(JSplitPane split, Runnable put) {
    split.addPropertyChangeListener(
        JSplitPane.DIVIDER_LOCATION_PROPERTY,
        event -> {
          if (isShowing() && !arranging && split.getWidth() > 0) {
            put.run();
          }
        });
  }

  private OptionalInt number(String setting) {
    return settings
        .get(setting)
        .filter(each -> each.matches("\\d{1,4}"))
        .map(each -> OptionalInt.of(Integer.parseInt(each)))
        .orElse(OptionalInt.empty());
  }

  /** What people have chosen, or what is usual, in pixels of the screen. */
  private int paletteWidth() {
    return UIScale.scale(number(PALETTE).orElse(USUAL_PALETTE));
  }

  /** As {@link #paletteWidth}. */
  private int treeWidth() {
    OptionalInt chosen = number(TREE);
    double share = chosen.isPresent() ? chosen.getAsInt() / 1000.0 : USUAL_TREE;
    return (int) Math.round(share * getWidth());
  }

  @Override
  public void doLayout() {
    arranging = true;
    boolean wanted = getWidth() > 0 && getWidth() < UIScale.scale(NARROW);
    if (wanted != narrow) {
      narrow = wanted;
      arrange();
    }
    super.doLayout();
    // They divide what they have gained their own way, once: the shares are set after that.
    if (!narrow) {
      outer.doLayout();
    }
    inner.doLayout();
    int room = getWidth() - (narrow ? 0 : outer.getDividerLocation() + outer.getDividerSize());
    int most = room - inner.getDividerSize() - UIScale.scale(MIN_TABS);
    int tree = Math.min(treeWidth(), most);
    inner.setDividerLocation(Math.max(UIScale.scale(MIN_TREE), tree));
    arranging = false;
  }

  /** What has the keyboard keeps it, in whichever place it is then. */
  private void arrange() {
    Component owner = KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    boolean inside = owner != null && SwingUtilities.isDescendingFrom(owner, this);
    if (narrow) {
      remove(outer);
      outer.setRightComponent(null);
      outer.setLeftComponent(null);
      tabs.insertTab(text("add"), null, palette, text("nodesToAdd"), 0);
      add(inner);
    } else {
      remove(inner);
      tabs.remove(palette);
      outer.setLeftComponent(palette);
      outer.setRightComponent(inner);
      outer.setDividerLocation(paletteWidth());
      add(outer);
    }
    if (inside) {
      owner.requestFocusInWindow();
    }
  }

  /** Brings the palette into sight. */
  void showPalette() {
    if (narrow) {
      tabs.setSelectedComponent(palette);
    }
  }
}
