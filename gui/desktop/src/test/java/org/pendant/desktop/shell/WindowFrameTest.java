package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.kit.settings.FileSettings;

/** The frame that people see before there is anything in it. */
final class WindowFrameTest {
  @TempDir Path folder;
  private FileSettings settings;
  private WindowFrame window;

  @BeforeEach
  void make() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display to open a window on");
    settings = FileSettings.open(folder.resolve("settings.txt"));
    EventQueue.invokeAndWait(() -> window = new WindowFrame(settings));
  }

  @AfterEach
  void end() throws Exception {
    if (window != null) {
      EventQueue.invokeAndWait(window::end);
      settings.close();
    }
  }

  @Test
  void itsPartsAreMadeOnceItIsSeen() throws Exception {
    CountDownLatch made = new CountDownLatch(1);
    EventQueue.invokeAndWait(() -> window.showOutline(made::countDown));
    assertTrue(made.await(30, TimeUnit.SECONDS));
    assertTrue(window.frame().isShowing());
  }

  @Test
  void theOutlineGivesWayToTheParts() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          window.showOutline(() -> {});
          assertEquals(1, window.frame().getContentPane().getComponentCount());
          window.removeOutline();
          assertEquals(0, window.frame().getContentPane().getComponentCount());
        });
  }

  @Test
  void whoeverClosesItBeforeThatIsAskedAfterwards() throws Exception {
    List<String> asked = new ArrayList<>();
    EventQueue.invokeAndWait(
        () -> {
          window.frame().dispatchEvent(new WindowEvent(window.frame(), WindowEvent.WINDOW_CLOSING));
          window.askedToClose(() -> asked.add("close?"));
        });
    EventQueue.invokeAndWait(() -> assertEquals(List.of("close?"), asked));
  }

  @Test
  void itAsksEachTimeThatPeopleCloseIt() throws Exception {
    List<String> asked = new ArrayList<>();
    EventQueue.invokeAndWait(
        () -> {
          window.askedToClose(() -> asked.add("close?"));
          for (int i = 0; i < 2; i++) {
            window
                .frame()
                .dispatchEvent(new WindowEvent(window.frame(), WindowEvent.WINDOW_CLOSING));
          }
        });
    assertEquals(List.of("close?", "close?"), asked);
  }
}
