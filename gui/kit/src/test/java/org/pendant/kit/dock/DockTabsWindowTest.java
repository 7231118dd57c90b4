package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JViewport;
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
