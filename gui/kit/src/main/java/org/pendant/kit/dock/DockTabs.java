package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import com.formdev.flatlaf.FlatLaf;
import java.awt.Graphics2D;
import java.util.List;
import java.util.function.IntConsumer;
import javax.swing.Icon;
import javax.swing.JButton;
import javax.swing.JTabbedPane;
import javax.swing.KeyStroke;
import javax.swing.UIManager;
import org.pendant.kit.icon.Glyph;
import org.pendant.kit.layout.WholeTabs;

/**
 * Dock tabs: one row; those without room are in a list behind three dots, which nobody takes for
 * the arrow that folds the dock.
 */
@SuppressWarnings("serial") // never written to a stream
final class DockTabs extends JTabbedPane {
  private static final int DOTS = 14;

  private transient IntConsumer listed = index -> {};

  DockTabs() {
    setTabLayoutPolicy(SCROLL_TAB_LAYOUT);
    putClientProperty("JTabbedPane.tabType", "underlined");
    // Arrows come and go, and cover what was just brought in sight: the wheel scrolls, too.
    putClientProperty("JTabbedPane.scrollButtonsPolicy", "never");
    putClientProperty("JTabbedPane.tabsPopupPolicy", "asNeeded");
    // the look turns tabs with Ctrl+Tab, which is an action of the window
    for (String keys : List.of("ctrl TAB", "ctrl shift TAB")) {
      getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(keys), "none");
    }
  }

  /** {@code chosen} hears which tab is chosen from the list behind the dots, selected or not. */
  void whenListed(IntConsumer chosen) {
    listed = chosen;
  }

  @Override
  public void updateUI() {
    if (UIManager.getLookAndFeel() instanceof FlatLaf) {
      setUI(new Tabs());
    } else {
      super.updateUI();
    }
  }

  private static final class Tabs extends WholeTabs {
    @Override
    protected JButton createMoreTabsButton() {
      return new Dots();
    }

    private final class Dots extends FlatMoreTabsButton {
      private final transient Icon dots = Glyph.MORE.icon(DOTS);

      Dots() {
        setToolTipText(text("morePanels"));
        getAccessibleContext().setAccessibleName(text("morePanels"));
      }

      @Override
      protected void selectTab(int tabIndex) {
        super.selectTab(tabIndex);
        ((DockTabs) tabPane).listed.accept(tabIndex);
      }

      @Override
      protected void paintArrow(Graphics2D pen) {
        int x = (getWidth() - dots.getIconWidth()) / 2;
        dots.paintIcon(this, pen, x, (getHeight() - dots.getIconHeight()) / 2);
      }
    }
  }
}
