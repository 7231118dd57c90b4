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
  void latenessIsThatOfTheLastFrames() {
    Lateness before = new Lateness(1000, 400, 90_000_000);
    Lateness now = new Lateness(2000, 405, 90_000_000);
    assertEquals("500 Hz, 0.5 % late", StatusLine.text(now, before.frames(), before.lateFrames()));
    assertEquals(" ", StatusLine.text(now, 2000, 405));
    String explained = StatusLine.explanation(now, 0.25);
    assertTrue(explained.endsWith("90.0 ms late, and robot time is 0.25 s behind the wall clock"));
  }
}
