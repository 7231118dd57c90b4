package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import org.junit.jupiter.api.Test;

final class TimeWindowTest {
  private static final TimeWindow STILL = new TimeWindow(100, 10, false);

  @Test
  void aLiveWindowGoesWithTheNewestSample() {
    assertEquals(120, new TimeWindow(100, 10, true).at(120).endS());
    assertEquals(100, STILL.at(120).endS());
  }

  @Test
  void zoomingKeepsWhatIsUnderThePointer() {
    TimeWindow zoomed = STILL.zoomed(0.5, 0.25);
    assertEquals(STILL.timeAt(0.25), zoomed.timeAt(0.25), 1e-12);
    assertEquals(5, zoomed.widthS(), 1e-12);
  }

  @Test
  void zoomingALiveWindowKeepsItsRightEdge() {
    assertEquals(100, new TimeWindow(100, 10, true).zoomed(2, 0.1).endS(), 1e-12);
  }

  @Test
  void widthsStayInTheirRange() {
    assertEquals(TimeWindow.WIDEST_S, STILL.withWidth(1e9).widthS());
    assertEquals(TimeWindow.NARROWEST_S, STILL.zoomed(0, 0.5).widthS());
  }

  @Test
  void aMovedWindowStandsStill() {
    TimeWindow moved = new TimeWindow(100, 10, true).moved(-0.5);
    assertEquals(95, moved.endS(), 1e-12);
    assertFalse(moved.live());
  }

  @Test
  void aSpanMayBeDrawnInEitherDirection() {
    assertEquals(STILL.between(91, 94), STILL.between(94, 91));
    assertEquals(91, STILL.between(94, 91).beginS(), 1e-12);
  }
}
