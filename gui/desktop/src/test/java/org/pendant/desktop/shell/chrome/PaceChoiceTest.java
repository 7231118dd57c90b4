package org.pendant.desktop.shell.chrome;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Pace;
import org.pendant.controller.WallClock.Lateness;

final class PaceChoiceTest {
  @Test
  void stepsNeverPauseAndEndAtFullSpeed() {
    assertEquals(new Pace.Times(2), PaceChoice.faster(Pace.REAL_TIME, 1));
    assertEquals(new Pace.Times(0.5), PaceChoice.faster(Pace.REAL_TIME, -1));
    assertEquals(new Pace.Times(0.1), PaceChoice.faster(new Pace.Times(0.1), -1));
    assertEquals(new Pace.Unlimited(), PaceChoice.faster(new Pace.Unlimited(), 1));
  }

  @Test
  void thePacesAreThoseOfAPendantAndMore() {
    assertEquals(
        List.of(
            "Paused", "x 0.1", "x 0.5", "Real time", "x 2", "x 5", "x 10", "As fast as possible"),
        PaceChoice.ALL.stream().map(PaceChoice::title).toList());
    assertEquals("x 3.5", PaceChoice.of(new Pace.Times(3.5)).title());
  }

  @Test
  void robotTimeThatKeepsItsPaceIsNotMentioned() {
    assertEquals("", StatusLine.text(Pace.REAL_TIME, 1000, 2));
    assertEquals("", StatusLine.text(Pace.REAL_TIME, 960, 2));
    assertEquals("", StatusLine.text(new Pace.Times(0.5), 500, 2));
    assertEquals("", StatusLine.text(new Pace.Unlimited(), 10, 2));
    assertEquals("", StatusLine.text(Pace.REAL_TIME, -5, 2));
  }

  @Test
  void robotTimeThatFallsBehindIsToldAsAShareOfItsPace() {
    assertEquals(
        "robot time at 62 % of real time: computer busy", StatusLine.text(Pace.REAL_TIME, 620, 2));
    assertEquals(
        "robot time at 50 % of its pace: computer busy",
        StatusLine.text(new Pace.Times(2), 1000, 2));
    String explained = StatusLine.explanation(new Lateness(2000, 405, 90_000_000), 0.25);
    assertTrue(explained.contains("20.3 % of all frames began more than 1 ms late"), explained);
    assertTrue(
        explained.endsWith("the latest 90.0 ms; robot time is 0.25 s behind the wall clock"));
  }
}
