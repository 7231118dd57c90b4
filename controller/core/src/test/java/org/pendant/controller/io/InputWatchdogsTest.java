package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.InputWatchdogs.Violation;

class InputWatchdogsTest {
  private static final String INPUT = "input_int_register_0";
  private static final Violation LATE = new Violation(INPUT, 10, WatchdogAction.PAUSE);

  private final InputWatchdogs watchdogs = new InputWatchdogs();

  @Test
  void barksOnceWhenThePeriodIsOver() {
    watchdogs.set(INPUT, 10, WatchdogAction.PAUSE, 5);
    assertEquals(List.of(), watchdogs.step(true, 5.1));
    assertEquals(List.of(LATE), watchdogs.step(true, 5.102));
    assertEquals(List.of(), watchdogs.step(true, 5.104));
  }

  @Test
  void everyUpdateBeginsThePeriodAnew() {
    watchdogs.set(INPUT, 10, WatchdogAction.PAUSE, 0);
    watchdogs.received(Set.of(INPUT, "speed_slider_mask"), 0.09);
    assertEquals(List.of(), watchdogs.step(true, 0.19));
    watchdogs.received(Set.of("speed_slider_mask"), 0.19);
    assertEquals(List.of(LATE), watchdogs.step(true, 0.192));
    watchdogs.received(Set.of(INPUT), 0.3);
    assertEquals(List.of(), watchdogs.step(true, 0.4));
    assertEquals(List.of(LATE), watchdogs.step(true, 0.402));
  }

  @Test
  void sleepsWhileTheProgramDoes() {
    watchdogs.set(INPUT, 10, WatchdogAction.PAUSE, 0);
    assertEquals(List.of(), watchdogs.step(false, 7));
    assertEquals(List.of(), watchdogs.step(true, 7.1));
    assertEquals(List.of(LATE), watchdogs.step(true, 7.102));
  }

  @Test
  void theLastOneForAnInputCounts() {
    watchdogs.set(INPUT, 10, WatchdogAction.PAUSE, 0);
    watchdogs.set(INPUT, 1, WatchdogAction.STOP, 0);
    assertEquals(List.of(), watchdogs.step(true, 1));
    assertEquals(
        List.of(new Violation(INPUT, 1, WatchdogAction.STOP)), watchdogs.step(true, 1.002));
  }

  @Test
  void anUnaskedOneComesOnlyWhereThereIsNone() {
    watchdogs.setUnlessAny(INPUT, 10, WatchdogAction.PAUSE, 0);
    watchdogs.setUnlessAny("speed_slider_mask", 10, WatchdogAction.PAUSE, 0);
    assertEquals(List.of(LATE), watchdogs.step(true, 1));
    watchdogs.removeUnasked();
    watchdogs.received(Set.of(INPUT), 1);
    assertEquals(List.of(), watchdogs.step(true, 9));
  }

  @Test
  void oneThatWasAskedForStays() {
    watchdogs.set(INPUT, 10, WatchdogAction.PAUSE, 0);
    watchdogs.removeUnasked();
    assertEquals(List.of(LATE), watchdogs.step(true, 1));
    watchdogs.clear();
    assertEquals(List.of(), watchdogs.step(true, 9));
  }
}
