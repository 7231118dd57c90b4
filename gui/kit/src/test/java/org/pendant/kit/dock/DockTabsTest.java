package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.util.HashSet;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JViewport;
import javax.swing.KeyStroke;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.kit.dispatch.OnDispatchThread;
import org.pendant.kit.theme.PreviewLook;

@OnDispatchThread
final class DockTabsTest {
  private static final int WIDTH = 300;
  private static final int HEIGHT = 120;

  @BeforeEach
  void look() {
    PreviewLook.change(false);
  }

  private static DockTabs tabs() {
    DockTabs tabs = new DockTabs();
    for (String title : new String[] {"Variables", "Watches", "Problems", "Breakpoints", "Log"}) {
      tabs.addTab(title, new JPanel());
    }
    tabs.setSize(WIDTH, HEIGHT);
    tabs.doLayout();
    return tabs;
  }

  /** What is in sight of the tabs. */
  private static Rectangle row(DockTabs tabs) {
    for (Component each : tabs.getComponents()) {
      if (each instanceof JViewport row) {
        row.doLayout();
        return row.getBounds();
      }
    }
    throw new AssertionError("the tabs do not scroll");
  }

  private static Set<Integer> colours(BufferedImage picture, Rectangle place) {
    Set<Integer> found = new HashSet<>();
    for (int y = place.y; y < place.y + place.height; y++) {
      for (int x = place.x; x < place.x + place.width; x++) {
        found.add(picture.getRGB(x, y));
      }
    }
    return found;
  }

  @Test
  void onlyTabsThatAreWhollyInSightAreWritten() {
    DockTabs tabs = tabs();
    Rectangle row = row(tabs);
    BufferedImage picture = new BufferedImage(WIDTH, HEIGHT, BufferedImage.TYPE_INT_RGB);
    Graphics2D pen = picture.createGraphics();
    tabs.paint(pen);
    pen.dispose();
    int whole = 0;
    int cut = 0;
    for (int i = 0; i < tabs.getTabCount(); i++) {
      Rectangle place = tabs.getBoundsAt(i);
      Rectangle seen = place.intersection(row);
      // without the line below the tabs
      seen.height -= 6;
      if (seen.isEmpty() || seen.width < 8) {
        continue;
      }
      int colours = colours(picture, seen).size();
      String title = tabs.getTitleAt(i);
      if (row.contains(place)) {
        whole++;
        assertTrue(colours > 1, title);
      } else {
        cut++;
        assertEquals(1, colours, title);
      }
    }
    assertTrue(whole >= 1 && cut >= 1, whole + " whole, " + cut + " cut");
  }

  @Test
  void ctrlTabIsLeftToTheWindow() {
    DockTabs tabs = new DockTabs();
    Object bound =
        tabs.getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT)
            .get(KeyStroke.getKeyStroke("ctrl TAB"));
    assertNull(tabs.getActionMap().get(bound), "the look turns tabs with it");
  }
}
