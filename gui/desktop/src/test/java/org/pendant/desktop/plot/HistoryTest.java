package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.DebugCommand;

final class HistoryTest {
  private static final ChartQuantity TIME =
      new ChartQuantity("time", "Test", "Time", "Time", "s", state -> state.timeS());

  private final RecordedArm arm = new RecordedArm();

  @Test
  void everyFourthFrameIsASample() {
    arm.frames(40);
    History history = new History(arm::recording);
    assertTrue(history.follow());
    TimeSeries series = history.of(TIME);
    assertEquals(10, series.end() - series.first());
    assertEquals(0.08, history.newestS(), 1e-9);
    assertFalse(history.follow());
  }

  @Test
  void aQuantityThatIsAddedLaterHasItsPast() {
    arm.frames(40);
    History history = new History(arm::recording);
    history.follow();
    history.track(TIME);
    arm.frames(40);
    history.follow();
    TimeSeries series = history.of(TIME);
    for (long number = series.first(); number < series.end(); number++) {
      assertEquals(series.timeS(number), series.value(TIME, number));
    }
    assertEquals(0.048, history.valueAt(TIME, 0.05), 1e-9);
    assertTrue(Double.isNaN(history.valueAt(TIME, 0.001)));
  }

  @Test
  void anotherControllerBeginsAnotherHistory() {
    arm.frames(400);
    History history = new History(arm::recording);
    history.track(TIME);
    history.follow();
    arm.restart();
    arm.frames(8);
    history.follow();
    assertEquals(2, history.of(TIME).end() - history.of(TIME).first());
    assertEquals(0.016, history.newestS(), 1e-9);
  }

  @Test
  void aBranchHasWhatWasBeforeItAndNothingOfTheOtherRun() {
    arm.frames(400);
    History history = new History(arm::recording);
    history.follow();
    arm.branch(100);
    arm.frames(500);
    history.anotherController();
    history.track(TIME);
    while (history.follow()) {
      // until everything is there
    }
    assertEquals(1.2, history.newestS(), 1e-9);
    TimeSeries series = history.of(TIME);
    assertEquals(150, series.end() - series.first());
    for (long number = series.first(); number < series.end(); number++) {
      assertEquals(series.timeS(number), series.value(TIME, number));
    }
  }

  @Test
  void muchThatIsNewComesPieceByPieceAndNoneOfItIsMissing() {
    arm.frames(History.FRAMES_PER_SAMPLE * (History.PIECE + 10));
    History history = new History(arm::recording);
    assertTrue(history.follow());
    assertTrue(history.behind());
    assertEquals(History.PIECE, history.of(TIME).end() - history.of(TIME).first());
    assertTrue(history.follow());
    assertFalse(history.behind());
    assertFalse(history.follow());
    history.track(TIME);
    assertTrue(history.follow());
    assertTrue(history.follow());
    assertFalse(history.follow());
    TimeSeries series = history.of(TIME);
    assertEquals(History.PIECE + 10, series.end() - series.first());
    for (long number = series.first(); number < series.end(); number++) {
      assertEquals(number * History.FRAMES_PER_SAMPLE / 500.0, series.value(TIME, number), 1e-9);
    }
  }

  @Test
  void samplesAreFoundByTime() {
    arm.frames(40);
    History history = new History(arm::recording);
    history.follow();
    TimeSeries series = history.of(TIME);
    assertEquals(series.first(), series.firstAtLeast(-1));
    assertEquals(series.end(), series.firstAtLeast(1));
    assertEquals(0.024, series.timeS(series.firstAtLeast(0.0179)), 1e-9);
  }

  @Test
  void aFileHasWhatTheWindowShows() throws IOException {
    arm.frames(40);
    History history = new History(arm::recording);
    history.follow();
    history.track(TIME);
    history.follow();
    StringBuilder text = new StringBuilder();
    TimeWindow window = new TimeWindow(0.08, 0.05, false).between(0.02, 0.0701);
    PlotCsv.of(history, List.of(TIME), window).write(text);
    List<String> lines = text.toString().lines().toList();
    assertEquals("time_s,time [s]", lines.getFirst());
    assertEquals(6, lines.size() - 1);
    assertEquals(lines.get(1).split(",", -1)[0], lines.get(1).split(",", -1)[1]);
  }

  @Test
  void noPeakIsLostHoweverFewPixelsThereAre() {
    ChartQuantity peak =
        new ChartQuantity("p", "Test", "Peak", "Peak", "", s -> s.frame() == 1000 ? 7 : 0);
    arm.frames(2000);
    History history = new History(arm::recording);
    history.follow();
    history.track(peak);
    history.follow();
    Columns columns = new Columns();
    columns.fill(history, peak, new TimeWindow(4, 4, false), 10);
    double most = 0;
    for (int x = 0; x < columns.width(); x++) {
      assertTrue(columns.has(x));
      most = Math.max(most, columns.most(x));
    }
    assertEquals(7, most);
  }

  @Test
  void aScriptVariableHasASampleOfEveryFrame() {
    History history = new History(arm::recording);
    history.track(COUNT);
    countUp();
    arm.frames(50);
    history.follow();
    TimeSeries series = history.of(COUNT);
    double before = Double.NaN;
    for (long number = series.first(); number < series.end(); number++) {
      double value = series.value(COUNT, number);
      if (number > series.first()) {
        assertEquals(0.002, series.timeS(number) - series.timeS(number - 1), 1e-9);
      }
      if (!Double.isNaN(before)) {
        assertEquals(before + 1, value);
      }
      before = value;
    }
    assertEquals(50, before);
  }

  private static final ChartQuantity COUNT = RecordedArm.quantity("var:i");

  private void countUp() {
    arm.trace("i");
    arm.run("def p():\n  i = 0\n  while True:\n    i = i + 1\n    sync()\n  end\nend\n");
  }

  @Test
  void aVariableIsUnknownBeforeItWasTracedAndThereNoLineIsDrawn() {
    arm.frames(100);
    History history = new History(arm::recording);
    history.track(COUNT);
    history.follow();
    countUp();
    arm.frames(100);
    history.follow();
    assertEquals(Double.NaN, history.valueAt(COUNT, 0.1));
    Columns columns = new Columns();
    columns.fill(history, COUNT, new TimeWindow(0.4, 0.4, false), 20);
    assertFalse(columns.has(5));
    assertTrue(columns.has(15));
    int begin = 0;
    while (!columns.has(begin)) {
      begin++;
    }
    assertTrue(columns.broken(begin), "where the value becomes known the line begins");
    assertFalse(columns.broken(begin + 1));
  }

  @Test
  void aHeldFrameIsOneSample() {
    History history = new History(arm::recording);
    history.track(TIME);
    countUp();
    arm.frames(43);
    var _ = arm.controller().submit(new DebugCommand.Debug(debugger -> debugger.pause()));
    arm.frames(30);
    assertTrue(arm.controller().state().debug().held());
    history.follow();
    assertEquals(11, history.of(TIME).end() - history.of(TIME).first());
  }

  @Test
  void aFileWithAVariableHasARowEachFrame() throws IOException {
    History history = new History(arm::recording);
    history.track(COUNT);
    history.track(TIME);
    countUp();
    arm.frames(40);
    history.follow();
    StringBuilder text = new StringBuilder();
    TimeWindow window = new TimeWindow(0.08, 0.05, false).between(0.0401, 0.0601);
    PlotCsv.of(history, List.of(COUNT, TIME), window).write(text);
    List<String> lines = text.toString().lines().toList();
    assertEquals("time_s,var:i,time [s]", lines.getFirst());
    assertEquals(20, lines.size() - 1, lines.toString());
    assertTrue(lines.get(1).matches("0\\.042,21\\.0,"), lines.get(1));
    assertEquals(5, lines.stream().skip(1).filter(line -> !line.endsWith(",")).count());
  }
}
