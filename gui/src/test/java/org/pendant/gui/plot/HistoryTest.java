package org.pendant.gui.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;

final class HistoryTest {
  private static final Quantity TIME =
      new Quantity("time", "Test", "Time", "Time", "s", state -> state.timeS());

  private final RecordedArm arm = new RecordedArm();

  @Test
  void everyFourthFrameIsASample() {
    arm.frames(40);
    History history = new History(arm.tape);
    assertTrue(history.follow());
    assertEquals(10, history.end() - history.first());
    assertEquals(0.08, history.newestS(), 1e-9);
    assertFalse(history.follow());
  }

  @Test
  void aQuantityThatIsAddedLaterHasItsPast() {
    arm.frames(40);
    History history = new History(arm.tape);
    history.follow();
    history.track(TIME);
    arm.frames(40);
    history.follow();
    for (long number = history.first(); number < history.end(); number++) {
      assertEquals(history.timeS(number), history.value(TIME, number));
    }
    assertEquals(0.048, history.valueAt(TIME, 0.05), 1e-9);
    assertTrue(Double.isNaN(history.valueAt(TIME, 0.001)));
  }

  @Test
  void anotherControllerBeginsAnotherHistory() {
    arm.frames(400);
    History history = new History(arm.tape);
    history.track(TIME);
    history.follow();
    arm.restart();
    arm.frames(8);
    history.follow();
    assertEquals(2, history.end() - history.first());
    assertEquals(0.016, history.newestS(), 1e-9);
  }

  @Test
  void samplesAreFoundByTime() {
    arm.frames(40);
    History history = new History(arm.tape);
    history.follow();
    assertEquals(history.first(), history.firstAtLeast(-1));
    assertEquals(history.end(), history.firstAtLeast(1));
    assertEquals(0.024, history.timeS(history.firstAtLeast(0.0179)), 1e-9);
  }

  @Test
  void aFileHasWhatTheWindowShows() throws IOException {
    arm.frames(40);
    History history = new History(arm.tape);
    history.follow();
    history.track(TIME);
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
    Quantity peak = new Quantity("p", "Test", "Peak", "Peak", "", s -> s.frame() == 1000 ? 7 : 0);
    arm.frames(2000);
    History history = new History(arm.tape);
    history.follow();
    history.track(peak);
    Columns columns = new Columns();
    columns.fill(history, peak, new TimeWindow(4, 4, false), 10);
    double most = 0;
    for (int x = 0; x < columns.width(); x++) {
      assertTrue(columns.has(x));
      most = Math.max(most, columns.most(x));
    }
    assertEquals(7, most);
  }
}
