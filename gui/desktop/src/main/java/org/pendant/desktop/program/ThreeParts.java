package org.pendant.desktop.program;

import com.formdev.flatlaf.util.UIScale;
import java.awt.BorderLayout;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JSplitPane;
import javax.swing.JTabbedPane;
import org.pendant.kit.settings.Settings;

/**
 * Layout of three parts: palette, tree and tabs beside each other. Where there is no room for all
 * three, the palette is one of the tabs.
 */
@SuppressWarnings("serial") // never written to a stream
final class ThreeParts extends JPanel {
  private static final int NARROW = 700;
  private static final int MIN_TABS = 320;
  private static final int MIN_TREE = 150;
  private static final int USUAL_TREE = 250;
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
    inner = split("program.tree-width", tree, tabs);
    outer = split("program.palette-width", palette, inner);
    outer.setDividerLocation(width("program.palette-width", USUAL_PALETTE));
    add(outer);
  }

  private JSplitPane split(String setting, JComponent left, JComponent right) {
    JSplitPane split = new JSplitPane(JSplitPane.HORIZONTAL_SPLIT, left, right);
    split.setName(setting.replace('.', '-'));
    split.setBorder(BorderFactory.createEmptyBorder());
    split.setContinuousLayout(true);
    split.addPropertyChangeListener(
        JSplitPane.DIVIDER_LOCATION_PROPERTY,
        event -> {
          if (isShowing() && !arranging && split.getWidth() > 0) {
            int unscaled = UIScale.unscale(split.getDividerLocation());
            settings.put(setting, String.valueOf(unscaled));
          }
        });
    return split;
  }

  /** What people have chosen, or what is usual, in pixels of the screen. */
  private int width(String setting, int usual) {
    return UIScale.scale(
        settings
            .get(setting)
            .filter(each -> each.matches("\\d{1,4}"))
            .map(Integer::parseInt)
            .orElse(usual));
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
    int room = getWidth() - (narrow ? 0 : outer.getDividerLocation() + outer.getDividerSize());
    int most = room - inner.getDividerSize() - UIScale.scale(MIN_TABS);
    int tree = Math.min(width("program.tree-width", USUAL_TREE), most);
    inner.setDividerLocation(Math.max(UIScale.scale(MIN_TREE), tree));
    arranging = false;
  }

  private void arrange() {
    if (narrow) {
      remove(outer);
      outer.setRightComponent(null);
      outer.setLeftComponent(null);
      tabs.insertTab("Add", null, palette, "Nodes to add", 0);
      add(inner);
    } else {
      remove(inner);
      tabs.remove(palette);
      outer.setLeftComponent(palette);
      outer.setRightComponent(inner);
      outer.setDividerLocation(width("program.palette-width", USUAL_PALETTE));
      add(outer);
    }
  }

  /** Brings the palette into sight. */
  void showPalette() {
    if (narrow) {
      tabs.setSelectedComponent(palette);
    }
  }
}
