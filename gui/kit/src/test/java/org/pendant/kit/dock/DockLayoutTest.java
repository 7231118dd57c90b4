package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.EventQueue;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.lang.reflect.InvocationTargetException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JLayer;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;

final class DockLayoutTest {
  /** A view of its name. */
  private record Named(String id, JComponent component) implements Dockable {
    @Override
    public String title() {
      return id;
    }
  }

  private static DockFrame frame() {
    Map<String, Side> home = new LinkedHashMap<>();
    home.put("script", Side.MAIN);
    home.put("scene", Side.RIGHT);
    home.put("variables", Side.LOWER);
    home.put("problems", Side.BOTTOM);
    List<Named> views = home.keySet().stream().map(id -> new Named(id, new JPanel())).toList();
    DockFrame frame =
        new DockFrame(
            new DockPlan(new MemorySettings(), home, Set.of()), views, home, window -> {});
    frame.setCollapsed(Side.BOTTOM, false);
    return frame;
  }

  private static void layOut(Component component) {
    component.doLayout();
    if (component instanceof Container parent) {
      for (Component each : parent.getComponents()) {
        layOut(each);
      }
    }
  }

  private static void watch(Container parent, List<String> moves) {
    for (Component each : parent.getComponents()) {
      each.addComponentListener(
          new ComponentAdapter() {
            @Override
            public void componentResized(ComponentEvent event) {
              moves.add(each.getName() + " has another size");
            }

            @Override
            public void componentMoved(ComponentEvent event) {
              moves.add(each.getName() + " is elsewhere");
            }
          });
    }
  }

  private static Container area(DockFrame frame) {
    return (Container) ((JLayer<?>) frame.component()).getView();
  }

  /** What moves has all beside it drawn again: a text that is longer must not have that. */
  @Test
  void nothingMovesWhereNothingHasChanged() throws InterruptedException, InvocationTargetException {
    List<String> moves = new ArrayList<>();
    DockFrame[] made = new DockFrame[1];
    EventQueue.invokeAndWait(
        () -> {
          made[0] = frame();
          made[0].component().setSize(1000, 700);
          layOut(made[0].component());
        });
    EventQueue.invokeAndWait(
        () -> {
          watch(area(made[0]), moves);
          area(made[0]).doLayout();
        });
    // what the layout told of itself comes before this
    EventQueue.invokeAndWait(() -> {});
    assertEquals(List.of(), moves);
  }

  private static Component named(DockFrame frame, String name) {
    return Stream.of(area(frame).getComponents())
        .filter(each -> name.equals(each.getName()))
        .findFirst()
        .orElseThrow();
  }

  /** As when 3D has a window of its own. */
  @Test
  void aLowerDockThatIsAloneGetsWiderByTheLineBesideIt()
      throws InterruptedException, InvocationTargetException {
    EventQueue.invokeAndWait(
        () -> {
          DockFrame frame = frame();
          frame.component().setSize(1000, 700);
          frame.move("scene", Side.MAIN);
          layOut(frame.component());
          Component line = named(frame, "dock-divider-right");
          assertTrue(line.isVisible());
          assertFalse(named(frame, "dock-divider-lower").isVisible());
          int before = line.getX();
          JComponent divider = (JComponent) line;
          divider.getActionMap().get("LEFT").actionPerformed(null);
          layOut(frame.component());
          assertEquals(before - 16, line.getX());
        });
  }
}
