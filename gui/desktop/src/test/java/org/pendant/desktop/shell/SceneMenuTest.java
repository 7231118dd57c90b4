package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JPopupMenu;
import javax.swing.MenuSelectionManager;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.preview.PreviewWorkbench;
import org.pendant.desktop.session.RobotSession;
import org.pendant.kit.dispatch.OnDispatchThread;

@Tag("slow")
@OnDispatchThread
final class SceneMenuTest {
  private static final int MOST = 14;

  @Test
  void theMenuOverTheNarrowestPictureHasFourteenEntriesAtMost() {
    assumeFalse(GraphicsEnvironment.isHeadless(), "there is no display");
    FlatLaf.setup(new FlatLightLaf());
    JFrame frame = new JFrame("3D");
    try (RobotSession session = RobotSession.start(ControllerOptions.headless())) {
      ScenePanel scene =
          new ScenePanel(new PreviewWorkbench(session), Optional::empty, Optional::empty);
      frame.add(scene.component());
      frame.setSize(300, 300);
      frame.setVisible(true);
      frame.validate();
      button(frame, "scene-more").doClick();
      JPopupMenu menu =
          (JPopupMenu) MenuSelectionManager.defaultManager().getSelectedPath()[0].getComponent();
      assertTrue(entries(menu) <= MOST, entries(menu) + " entries");
      for (Component each : menu.getComponents()) {
        assertTrue(!(each instanceof JMenu sub) || entries(sub.getPopupMenu()) <= MOST);
      }
      MenuSelectionManager.defaultManager().clearSelectedPath();
    } finally {
      frame.dispose();
    }
  }

  private static long entries(Container menu) {
    return Arrays.stream(menu.getComponents()).filter(Component::isVisible).count();
  }

  private static AbstractButton button(Container container, String name) {
    return all(container)
        .filter(each -> name.equals(each.getName()))
        .map(AbstractButton.class::cast)
        .findFirst()
        .orElseThrow();
  }

  private static Stream<Component> all(Component component) {
    return component instanceof Container container
        ? Stream.concat(
            Stream.of(component),
            Arrays.stream(container.getComponents()).flatMap(SceneMenuTest::all))
        : Stream.of(component);
  }
}
