package org.pendant.kit.dock;

import static org.junit.jupiter.api.Assertions.assertEquals;

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
import java.util.Optional;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.JLayer;
import javax.swing.JPanel;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.Settings;

final class DockLayoutTest {
  /** Remembers nothing. */
  private static final Settings NO_SETTINGS =
      new Settings() {
        @Override
        public Optional<String> get(String name) {
          return Optional.empty();
        }

        @Override
        public void put(String name, String text) {}
      };

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
        new DockFrame(new DockPlan(NO_SETTINGS, home, Set.of()), views, home, window -> {});
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
}
