package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.EventQueue;
import java.awt.Rectangle;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.swing.JComponent;
import javax.swing.RepaintManager;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;

/** Charts below each other, in no window. */
final class ChartStackTest {
  private final RecordedArm arm = new RecordedArm();

  /** Keeps what is to be painted. */
  private static final class Asked extends RepaintManager {
    private final Map<JComponent, Rectangle> places = new LinkedHashMap<>();

    @Override
    public void addDirtyRegion(JComponent part, int x, int y, int width, int height) {
      places.put(part, new Rectangle(x, y, width, height));
    }
  }

  @Test
  void allChartsAreDrawnForTheSameMoment() throws Exception {
    PlotPresenter presenter =
        new PlotPresenter(
            ChartQuantities.standard(),
            new History(arm::recording),
            new MemorySettings(new HashMap<>(Map.of("plot.charts", ""))));
    presenter.addChart(RecordedArm.quantity("torque_0"));
    presenter.addChart(RecordedArm.quantity("current_0"));
    arm.frames(100);
    EventQueue.invokeAndWait(
        () -> {
          ChartStack stack = new ChartStack(presenter, () -> {});
          stack.setSize(600, 500);
          RepaintManager before = RepaintManager.currentManager(stack);
          Asked asked = new Asked();
          RepaintManager.setCurrentManager(asked);
          try {
            assertTrue(presenter.refresh());
            stack.refresh();
          } finally {
            RepaintManager.setCurrentManager(before);
          }
          assertEquals(new Rectangle(0, 0, 600, 500), asked.places.get(stack), "in one piece");
          List<String> alone = new ArrayList<>();
          asked.places.keySet().forEach(each -> alone.add(String.valueOf(each.getName())));
          assertTrue(
              alone.stream().noneMatch(List.of("plot-chart", "plot-time-axis")::contains),
              alone::toString);
        });
  }
}
