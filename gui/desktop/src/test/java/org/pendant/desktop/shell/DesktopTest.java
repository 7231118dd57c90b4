package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Frame;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.kit.settings.ConfigurationFolder;

/** The whole window, where there is a display. */
@Tag("slow")
final class DesktopTest {
  /** An edge that is no farther from its line does not seem to move. */
  private static final int OUTLINE_PX = 3;

  @TempDir Path folder;

  @Test
  @Timeout(value = 60, unit = TimeUnit.SECONDS)
  void itOpensRemembersAndCloses() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display to open a window on");
    System.setProperty(ConfigurationFolder.PROPERTY, folder.toString());
    try {
      Desktop desktop = Desktop.open();
      Frame frame = frame();
      EventQueue.invokeAndWait(
          () -> {
            for (String name : new String[] {"program-run", "program-stop", "rail-run"}) {
              assertTrue(find(frame, name).orElseThrow().isShowing(), name);
            }
            assertOutlined((JFrame) frame);
            ((AbstractButton) find(frame, "rail-log").orElseThrow()).doClick();
          });
      place(frame, new Rectangle(0, 0, 1024, 700));
      EventQueue.invokeAndWait(
          () -> frame.dispatchEvent(new WindowEvent(frame, WindowEvent.WINDOW_CLOSING)));
      desktop.awaitClosed();
      String settings = Files.readString(folder.resolve("settings.txt"));
      assertTrue(settings.contains("dock.screen = log"), settings);
      assertTrue(settings.contains("window.bounds = 0 0 1024 700"), settings);
      assertEquals(0, Arrays.stream(Window.getWindows()).filter(Window::isShowing).count());
    } finally {
      System.clearProperty(ConfigurationFolder.PROPERTY);
    }
  }

  /** The outline that people see first has its lines where the parts have their edges. */
  private static void assertOutlined(JFrame frame) {
    Container root = frame.getRootPane();
    Rectangle middle = WindowOutline.middle(root.getSize());
    Rectangle rail = boundsIn(root, find(frame, "rail").orElseThrow());
    Rectangle footer = boundsIn(root, find(frame, "footer").orElseThrow());
    assertEquals(rail.y, middle.y, OUTLINE_PX, "top");
    assertEquals(rail.x + rail.width, middle.x, OUTLINE_PX, "left");
    assertEquals(footer.y, middle.y + middle.height, OUTLINE_PX, "bottom");
  }

  private static Rectangle boundsIn(Container root, Component part) {
    return SwingUtilities.convertRectangle(part.getParent(), part.getBounds(), root);
  }

  /**
   * The window with its parts. Waits in the dispatch thread's own order: each turn comes after what
   * was waiting there.
   */
  private static Frame frame() throws Exception {
    while (true) {
      EventQueue.invokeAndWait(() -> {});
      for (Frame each : Frame.getFrames()) {
        if ("pendant".equals(each.getName()) && find(each, "header").isPresent()) {
          return each;
        }
      }
    }
  }

  /**
   * Moves a window. The display tells a moment after it has shown one where that is, and a window
   * that was moved meanwhile is there again for what asks it: it is moved until the display says
   * so.
   */
  private static void place(Frame frame, Rectangle wanted) throws Exception {
    AtomicBoolean there = new AtomicBoolean();
    frame.addComponentListener(
        new ComponentAdapter() {
          @Override
          public void componentResized(ComponentEvent event) {
            there.set(frame.getBounds().equals(wanted));
          }

          @Override
          public void componentMoved(ComponentEvent event) {
            there.set(frame.getBounds().equals(wanted));
          }
        });
    while (!there.get()) {
      EventQueue.invokeAndWait(
          () -> {
            if (!frame.getBounds().equals(wanted)) {
              frame.setBounds(wanted);
            }
          });
    }
  }

  private static Optional<Component> find(Container in, String name) {
    for (Component each : in.getComponents()) {
      if (name.equals(each.getName())) {
        return Optional.of(each);
      }
      if (each instanceof Container container) {
        Optional<Component> found = find(container, name);
        if (found.isPresent()) {
          return found;
        }
      }
    }
    return Optional.empty();
  }
}
