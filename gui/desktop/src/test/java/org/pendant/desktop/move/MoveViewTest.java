package org.pendant.desktop.move;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JFrame;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.dispatch.OnDispatchThread;

@OnDispatchThread
final class MoveViewTest {
  private RobotSession session;
  private JFrame frame;

  @BeforeEach
  void start() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    session = RobotSession.start(ControllerOptions.headless());
    frame = new JFrame("Move");
  }

  @AfterEach
  void close() {
    if (session != null) {
      frame.dispose();
      session.close();
    }
  }

  private static Optional<Component> find(Container in, String name) {
    for (Component each : in.getComponents()) {
      Optional<Component> found =
          name.equals(each.getName())
              ? Optional.of(each)
              : each instanceof Container inner ? find(inner, name) : Optional.empty();
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  /** Where the top of a component is in the view. */
  private static int top(JComponent view, String name) {
    Component found = find(view, name).orElseThrow(() -> new AssertionError("no " + name));
    return SwingUtilities.convertPoint(found, 0, 0, view).y;
  }

  @Test
  void theReasonWhyTheArmCannotBeMovedMovesNoCard() {
    MoveView view = new MoveView(new PreviewWorkbench(session));
    JComponent whole = view.component();
    frame.add(whole);
    frame.addNotify();
    frame.setSize(500, 490);
    view.refresh(session.state());
    frame.validate();
    int before = top(whole, "move-scroll");
    session.setPace(new Pace.Paused());

    view.refresh(session.state());
    frame.validate();

    Component bar = find(whole, "move-obstacle-bar").orElseThrow();
    Component words = find(whole, "move-obstacle").orElseThrow();
    assertTrue(bar.isVisible());
    assertEquals(before, top(whole, "move-scroll"));
    assertTrue(bar.getHeight() <= words.getHeight() + 40, "blank around: " + bar.getHeight());
  }
}
