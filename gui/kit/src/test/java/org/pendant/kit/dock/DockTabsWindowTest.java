package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JMenuItem;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import javax.swing.JViewport;
import javax.swing.MenuSelectionManager;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.kit.theme.PreviewLook;

/** The tabs of a dock in a window. */
final class DockTabsWindowTest {
  private JFrame frame;
  private DockTabs tabs;

  @AfterEach
  void close() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          if (frame != null) {
            frame.dispose();
          }
          PreviewLook.change(false);
        });
  }

  @Test
  void theChosenTabStaysInSightWhenTheColoursChange() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    EventQueue.invokeAndWait(
        () -> {
          PreviewLook.change(false);
          tabs = new DockTabs();
          Stream.of("Variables", "Watches", "Problems", "Breakpoints", "Log")
              .forEach(title -> tabs.addTab(title, new JPanel()));
          frame = new JFrame("tabs");
          frame.add(tabs);
          frame.setSize(300, 200);
          frame.setVisible(true);
        });
    EventQueue.invokeAndWait(() -> tabs.setSelectedIndex(4));
    assertChosenInSight("before");
    EventQueue.invokeAndWait(
        () -> {
          PreviewLook.change(true);
          SwingUtilities.updateComponentTreeUI(frame);
        });
    assertChosenInSight("after");
  }

  @Test
  void whatIsChosenFromTheListIsTold() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    List<Integer> chosen = new ArrayList<>();
    EventQueue.invokeAndWait(
        () -> {
          PreviewLook.change(false);
          tabs = new DockTabs();
          tabs.whenListed(chosen::add);
          Stream.of("Variables", "Watches", "Problems", "Breakpoints", "Log")
              .forEach(title -> tabs.addTab(title, new JPanel()));
          tabs.setSelectedIndex(-1);
          frame = new JFrame("tabs");
          frame.add(tabs);
          frame.setSize(300, 200);
          frame.setVisible(true);
          JButton dots =
              Stream.of(tabs.getComponents())
                  .filter(JButton.class::isInstance)
                  .map(JButton.class::cast)
                  .filter(Component::isVisible)
                  .findFirst()
                  .orElseThrow();
          dots.doClick();
          JPopupMenu list = (JPopupMenu) MenuSelectionManager.defaultManager().getSelectedPath()[0];
          ((JMenuItem) list.getComponent(list.getComponentCount() - 1)).doClick();
        });
    assertEquals(List.of(4), chosen);
  }

  private void assertChosenInSight(String when) throws Exception {
    // what was asked for later has been done
    for (int i = 0; i < 3; i++) {
      EventQueue.invokeAndWait(() -> {});
    }
    EventQueue.invokeAndWait(
        () -> {
          Rectangle place = tabs.getBoundsAt(4);
          assertTrue(row().contains(place), () -> when + ": " + place + " in " + row());
        });
  }

  private Rectangle row() {
    for (Component each : tabs.getComponents()) {
      if (each instanceof JViewport row) {
        return row.getBounds();
      }
    }
    throw new AssertionError("the tabs do not scroll");
  }
}
