package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;

final class PlotPresenterTest {
  private final Map<String, String> remembered = new HashMap<>();
  private final RecordedArm arm = new RecordedArm();

  private PlotPresenter open() {
    Settings settings = new MemorySettings(remembered);
    return new PlotPresenter(ChartQuantities.standard(), new History(arm::recording), settings);
  }

  private static List<String> ids(PlotPresenter presenter) {
    return presenter.charts().stream().map(Chart::ids).toList();
  }

  private PlotPresenter empty() {
    remembered.put("plot.charts", "");
    return open();
  }

  @Test
  void aQuantityJoinsTheChartOfItsUnit() {
    PlotPresenter presenter = empty();
    presenter.add(RecordedArm.quantity("torque_0"));
    presenter.add(RecordedArm.quantity("current_0"));
    presenter.add(RecordedArm.quantity("torque_1"));
    assertEquals(List.of("torque_0,torque_1", "current_0"), ids(presenter));
  }

  @Test
  void chartsAreThereAgainTheNextTime() {
    PlotPresenter presenter = empty();
    presenter.add(RecordedArm.quantity("torque_0"));
    presenter.add(RecordedArm.quantity("current_0"));
    presenter.setWindow(presenter.window().withWidth(120));
    assertEquals(List.of("torque_0", "current_0"), ids(open()));
    assertEquals(120, open().window().widthS());
  }

  @Test
  void quantitiesThatAreNotKnownAnyMoreAreLeftOut() {
    remembered.put("plot.charts", "gone;torque_0,gone");
    remembered.put("plot.width-s", "wide");
    assertEquals(List.of("torque_0"), ids(open()));
    assertEquals(30, open().window().widthS());
  }

  @Test
  void aChartGoesWithItsLastQuantity() {
    PlotPresenter presenter = empty();
    presenter.add(RecordedArm.quantity("torque_0"));
    presenter.remove(presenter.charts().getFirst(), RecordedArm.quantity("payload"));
    assertEquals(1, presenter.charts().size());
    Chart chart = presenter.charts().getFirst();
    presenter.remove(chart, chart.traces().getFirst().quantity());
    assertEquals(List.of(), presenter.charts());
  }

  @Test
  void aColourThatBecameFreeIsUsedAgain() {
    Chart chart = new Chart();
    chart.add(RecordedArm.quantity("torque_0"));
    chart.add(RecordedArm.quantity("torque_1"));
    chart.remove(chart.traces().getFirst().quantity());
    chart.add(RecordedArm.quantity("torque_2"));
    assertEquals(List.of(1, 0), chart.traces().stream().map(ChartTrace::color).toList());
  }

  @Test
  void aPausedWindowStandsWhileRecordingGoesOn() {
    PlotPresenter presenter = open();
    arm.frames(100);
    presenter.refresh();
    presenter.pause(true);
    arm.frames(100);
    assertTrue(presenter.refresh());
    assertEquals(0.2, presenter.window().endS(), 1e-9);
    presenter.pause(false);
    assertEquals(0.4, presenter.window().endS(), 1e-9);
  }

  @Test
  void cursorsTellValuesAndTheirDifference() {
    PlotPresenter presenter = empty();
    ChartQuantity ramp =
        new ChartQuantity("ramp", "Test", "Ramp", "Ramp", "m", s -> 10 * s.timeS());
    presenter.addChart(ramp);
    arm.frames(600);
    presenter.refresh();
    assertEquals("12.00 m", presenter.legend(ramp));
    presenter.showCursors(true);
    presenter.moveCursor(0.4);
    presenter.moveCursor(0.9);
    assertEquals("A 4.00  B 8.96  \u0394 4.96 m", presenter.legend(ramp));
    assertTrue(presenter.paused());
    presenter.showCursors(false);
    assertFalse(presenter.cursors().isPresent());
  }

  @Test
  void signalsAreHighOrLow() {
    assertEquals("high", Readout.of(RecordedArm.quantity("digital_in_0"), 1));
    assertEquals("low", Readout.of(RecordedArm.quantity("digital_in_0"), 0));
    assertEquals("\u2013", Readout.of(RecordedArm.quantity("digital_in_0"), Double.NaN));
  }

  @Test
  void scriptVariablesShareAChartAndAreThereAgain() {
    PlotPresenter presenter = empty();
    presenter.add(RecordedArm.quantity("program_line"));
    presenter.add(RecordedArm.quantity("var:count"));
    presenter.add(RecordedArm.quantity("var:p[2]"));
    assertEquals(List.of("program_line", "var:count,var:p[2]"), ids(presenter));
    assertEquals(List.of("program_line", "var:count,var:p[2]"), ids(open()));
  }

  @Test
  void whoeverTracesIsToldWhichVariablesAreDrawn() {
    PlotPresenter presenter = empty();
    List<List<String>> told = new ArrayList<>();
    presenter.add(RecordedArm.quantity("var:count"));
    presenter.onTraced(told::add);
    presenter.addChart(RecordedArm.quantity("var:p[2]"));
    presenter.add(RecordedArm.quantity("torque_0"));
    presenter.remove(presenter.charts().getFirst());
    assertEquals(
        List.of(
            List.of("count"), List.of("count", "p[2]"), List.of("count", "p[2]"), List.of("p[2]")),
        told);
  }

  @Test
  void aFullChartTakesNoMore() {
    PlotPresenter presenter = empty();
    List<String> told = new ArrayList<>();
    presenter.onRefusal(told::add);
    presenter.addChart(RecordedArm.quantity("payload"));
    Chart chart = presenter.charts().getFirst();
    for (int i = 0; i < 20; i++) {
      presenter.addTo(chart, RecordedArm.quantity("output_float_register_" + i));
    }
    assertEquals(Chart.MOST, chart.traces().size());
    assertEquals("A chart has at most 12 lines: drop the others beside it", told.getFirst());
  }
}
