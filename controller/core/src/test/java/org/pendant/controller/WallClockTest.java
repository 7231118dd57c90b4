package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

final class WallClockTest {
  private long nowNs = 1_000;

  @Test
  void lateFramesAreCountedAndCaughtUp() throws InterruptedException {
    WallClock clock = new WallClock(1, () -> nowNs);
    clock.awaitDue();
    nowNs += 7_000_000;
    clock.awaitDue(); // was due at 2 ms
    nowNs += 1_000_000;
    clock.awaitDue(); // was due at 4 ms
    nowNs += 1_000_000;
    clock.awaitDue(); // was due at 6 ms
    assertEquals(new WallClock.Lateness(4, 3, 5_000_000), clock.lateness());
    assertEquals(0, clock.lostNs());
  }

  @Test
  void aLongDelayIsDropped() throws InterruptedException {
    WallClock clock = new WallClock(1, () -> nowNs);
    clock.awaitDue();
    nowNs += 5_000_000_000L;
    clock.awaitDue();
    nowNs += 2_000_000;
    clock.awaitDue(); // on time again
    assertEquals(new WallClock.Lateness(3, 1, 4_998_000_000L), clock.lateness());
    assertEquals(4_998_000_000L, clock.lostNs());
  }

  @Test
  void aFactorShortensTheFrames() throws InterruptedException {
    WallClock clock = new WallClock(4, () -> nowNs);
    clock.awaitDue();
    nowNs += 3_500_000;
    clock.awaitDue(); // was due at 0.5 ms
    assertEquals(3_000_000, clock.lateness().worstNs());
  }

  @Test
  void whileSomebodyOutsideIsWaitedForAFactorShortensNothing() throws InterruptedException {
    WallClock clock = new WallClock(4, () -> nowNs);
    clock.awaitDue(() -> true);
    nowNs += 3_500_000;
    clock.awaitDue(); // was due at 2 ms
    assertEquals(1_500_000, clock.lateness().worstNs());
  }

  @Test
  void anInterruptEndsALateFrameToo() throws InterruptedException {
    WallClock clock = new WallClock(1, () -> nowNs);
    clock.awaitDue();
    nowNs += 7_000_000;
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, clock::awaitDue);
  }

  @Test
  void refusesFactorsThatAreNoPace() {
    for (double factor : new double[] {0, -1, Double.NaN, 1e9}) {
      assertThrows(IllegalArgumentException.class, () -> new WallClock(factor));
    }
  }
}
