package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.BorderLayout;
import java.awt.Color;
import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.GridLayout;
import java.awt.image.BufferedImage;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.fault.ReportedFaults;

final class GuardedViewTest {
  private final ReportedFaults faults = new ReportedFaults();
  private final ControllerState state =
      new Controller(ControllerOptions.headless(), StandardBuiltins.create()).state();

  @AfterEach
  void stopListening() {
    faults.close();
  }

  /** Throws as long as it is told to. */
  private static final class Fickle implements View {
    private boolean refreshThrows;
    private boolean paintThrows;
    private int refreshes;
    private final JPanel panel =
        new JPanel() {
          @Override
          protected void paintComponent(Graphics pen) {
            if (paintThrows) {
              throw new IllegalStateException("cannot be painted");
            }
            pen.setColor(Color.GREEN);
            pen.fillRect(0, 0, getWidth(), getHeight());
          }
        };

    @Override
    public String id() {
      return "fickle";
    }

    @Override
    public String title() {
      return "Fickle";
    }

    @Override
    public JComponent component() {
      return panel;
    }

    @Override
    public void refresh(ControllerState state) {
      refreshes++;
      if (refreshThrows) {
        throw new StackOverflowError();
      }
    }
  }

  @Test
  void aViewThatThrowsInRefreshSaysThatItIsOldUntilItWorksAgain() throws Exception {
    Fickle view = new Fickle();
    GuardedView guarded = new GuardedView(view);
    view.refreshThrows = true;
    onScreen(() -> guarded.refresh(state));
    assertTrue(note(guarded).orElseThrow().contains("Fickle shows an old state"));
    assertEquals(1, faults.all().size());
    view.refreshThrows = false;
    for (int turn = 0; turn <= GuardedView.REST_TURNS; turn++) {
      onScreen(() -> guarded.refresh(state));
    }
    assertEquals(Optional.empty(), note(guarded));
  }

  @Test
  void aViewThatGoesOnThrowingIsAskedOnceASecondOnly() throws Exception {
    Fickle view = new Fickle();
    view.refreshThrows = true;
    GuardedView guarded = new GuardedView(view);
    for (int turn = 0; turn < 10 * (GuardedView.REST_TURNS + 1); turn++) {
      onScreen(() -> guarded.refresh(state));
    }
    assertEquals(10, view.refreshes);
    assertEquals(10, faults.all().size());
  }

  @Test
  void aViewThatCannotBeDrawnLeavesTheOthersDrawnAndSaysSo() throws Exception {
    Fickle broken = new Fickle();
    Fickle sound = new Fickle();
    GuardedView guarded = new GuardedView(broken);
    JPanel window = new JPanel(new GridLayout(1, 2));
    onScreen(
        () -> {
          window.add(guarded.component());
          window.add(new GuardedView(sound).component());
          window.setSize(400, 200);
          // views are made when they are in a window
          window.addNotify();
          layOut(window);
        });
    broken.paintThrows = true;
    BufferedImage image = draw(window);
    assertEquals(Color.GREEN.getRGB(), image.getRGB(300, 150), "the other view is not drawn");
    assertFalse(image.getRGB(100, 150) == Color.GREEN.getRGB(), "the broken view is drawn");
    assertTrue(note(guarded).orElseThrow().contains("Fickle cannot be drawn"));
    broken.paintThrows = false;
    draw(window);
    assertEquals(Optional.empty(), note(guarded));
  }

  @Test
  void aViewInATabIsMadeWhenThatIsInFrontFirst() throws Exception {
    List<String> made = new ArrayList<>();
    onScreen(
        () -> {
          JTabbedPane tabs = new JTabbedPane();
          for (String id : List.of("first", "second", "third")) {
            LateView late =
                new LateView(
                    id,
                    id,
                    () -> {
                      made.add(id);
                      return new Fickle();
                    });
            tabs.addTab(late.title(), new GuardedView(late).component());
          }
          JPanel window = new JPanel(new BorderLayout());
          window.add(tabs);
          window.setSize(400, 200);
          window.addNotify();
          layOut(window);
          assertEquals(List.of("first"), made);
          tabs.setSelectedIndex(2);
          layOut(window);
          assertEquals(List.of("first", "third"), made);
          tabs.setSelectedIndex(0);
          layOut(window);
          tabs.setSelectedIndex(2);
          layOut(window);
          assertEquals(List.of("first", "third"), made);
        });
  }

  private static void onScreen(Runnable action) throws Exception {
    EventQueue.invokeAndWait(action);
  }

  private static BufferedImage draw(JPanel window) throws Exception {
    BufferedImage image =
        new BufferedImage(window.getWidth(), window.getHeight(), BufferedImage.TYPE_INT_RGB);
    onScreen(() -> window.print(image.getGraphics()));
    // What was found out while drawing is shown afterwards.
    onScreen(() -> {});
    return image;
  }

  private static void layOut(Container container) {
    container.doLayout();
    for (Component each : container.getComponents()) {
      if (each instanceof Container inner) {
        layOut(inner);
      }
    }
  }

  /** What the strip of a view says, if it is there. */
  private static Optional<String> note(GuardedView view) throws Exception {
    StringBuilder words = new StringBuilder();
    onScreen(() -> collect(view.component(), words));
    return Optional.of(words.toString()).filter(text -> !text.isEmpty());
  }

  private static void collect(Container in, StringBuilder words) {
    for (Component each : in.getComponents()) {
      if (!each.isVisible()) {
        continue;
      }
      if (each instanceof JTextComponent text) {
        words.append(text.getText());
      } else if (each instanceof Container inner) {
        collect(inner, words);
      }
    }
  }
}
