package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.EventQueue;
import java.awt.GraphicsEnvironment;
import java.awt.KeyboardFocusManager;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.theme.PreviewLook;

/** Where keys go when docks are folded, in a window: never to the lines between them. */
final class DockFocusWindowTest {
  private final Map<String, JComponent> parts = new LinkedHashMap<>();
  private final JButton start = new JButton("start");
  private JFrame frame;
  private DockFrame docks;

  private Dockable view(String id, JComponent... inner) {
    JPanel content = new JPanel();
    for (JComponent each : inner) {
      content.add(each);
    }
    parts.put(id, inner[inner.length - 1]);
    return new Dockable() {
      @Override
      public String id() {
        return id;
      }

      @Override
      public String title() {
        return id;
      }

      @Override
      public JComponent component() {
        return content;
      }
    };
  }

  @BeforeEach
  void open() throws Exception {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    CountDownLatch focused = new CountDownLatch(1);
    EventQueue.invokeAndWait(
        () -> {
          PreviewLook.change(false);
          Map<String, Side> home = new LinkedHashMap<>();
          home.put("text", Side.MAIN);
          home.put("scene", Side.RIGHT);
          home.put("values", Side.LOWER);
          home.put("problems", Side.BOTTOM);
          List<Dockable> views =
              List.of(
                  view("text", start, new JTextArea("text", 5, 20)),
                  view("scene", new JTextArea("scene", 5, 10)),
                  view("values", new JTextArea("values", 5, 10)),
                  view("problems", new JTextArea("problems", 5, 10)));
          docks =
              new DockFrame(
                  new DockPlan(new MemorySettings(), home, Set.of("text")),
                  views,
                  home,
                  window -> {});
          docks.setCollapsed(Side.BOTTOM, false);
          frame = new JFrame("docks");
          frame.add(docks.component());
          frame.setSize(900, 700);
          frame.addWindowFocusListener(
              new WindowAdapter() {
                @Override
                public void windowGainedFocus(WindowEvent event) {
                  focused.countDown();
                }
              });
          frame.setVisible(true);
          frame.requestFocus();
        });
    assertTrue(focused.await(20, TimeUnit.SECONDS), "the window has no keys");
  }

  @AfterEach
  void close() throws Exception {
    EventQueue.invokeAndWait(
        () -> {
          if (frame != null) {
            frame.dispose();
          }
        });
  }

  private void show(String id) throws Exception {
    EventQueue.invokeAndWait(() -> docks.show(id));
    await(parts.get(id));
  }

  /** Waits until a component has the keys. */
  private static void await(JComponent wanted) throws Exception {
    CountDownLatch there = new CountDownLatch(1);
    KeyboardFocusManager manager = KeyboardFocusManager.getCurrentKeyboardFocusManager();
    EventQueue.invokeAndWait(
        () -> {
          manager.addPropertyChangeListener(
              "permanentFocusOwner",
              event -> {
                if (wanted == event.getNewValue()) {
                  there.countDown();
                }
              });
          if (wanted.isFocusOwner()) {
            there.countDown();
          }
        });
    assertTrue(
        there.await(10, TimeUnit.SECONDS), () -> "keys go to " + manager.getPermanentFocusOwner());
    settle();
    assertTrue(wanted.isFocusOwner(), () -> "then keys go to " + manager.getFocusOwner());
  }

  /** Lets what was asked of the focus be done. */
  private static void settle() throws Exception {
    for (int i = 0; i < 5; i++) {
      EventQueue.invokeAndWait(() -> {});
    }
  }

  @Test
  void keysOfADockThatIsFoldedGoToTheMainArea() throws Exception {
    show("text");
    show("problems");
    EventQueue.invokeAndWait(() -> docks.toggle(Side.BOTTOM));
    await(parts.get("text"));
  }

  @Test
  void keysOfTheLowerDockGoToTheMainAreaWhenTheColumnIsFolded() throws Exception {
    show("text");
    show("values");
    EventQueue.invokeAndWait(() -> docks.toggle(Side.RIGHT));
    await(parts.get("text"));
  }

  @Test
  void keysOfADockThatStaysStayThere() throws Exception {
    show("values");
    EventQueue.invokeAndWait(() -> docks.toggle(Side.BOTTOM));
    settle();
    await(parts.get("values"));
  }

  @Test
  void keysGoToTheTextWhereTheButtonThatHadThemIsDisabledNow() throws Exception {
    show("text");
    EventQueue.invokeAndWait(start::requestFocusInWindow);
    await(start);
    show("problems");
    EventQueue.invokeAndWait(
        () -> {
          start.setEnabled(false);
          docks.toggle(Side.BOTTOM);
        });
    await(parts.get("text"));
  }
}
