package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

final class VirtualClockTest {
  private static final long FRAME_NS = 2_000_000;

  private long nowNs;

  /** Each look at the time takes a millisecond. */
  private long look() {
    nowNs += FRAME_NS / 2;
    return nowNs;
  }

  @Test
  void framesAreDueAtOnce() throws InterruptedException {
    VirtualClock clock = new VirtualClock(this::look);
    for (int i = 0; i < 100; i++) {
      clock.awaitDue();
    }
    assertEquals(0, nowNs);
  }

  @Test
  void whileSomebodyOutsideIsWaitedForTheyComeNoFasterThanInRealTime() throws InterruptedException {
    VirtualClock clock = new VirtualClock(this::look);
    for (int i = 0; i < 11; i++) {
      clock.awaitDue(() -> true);
    }
    assertTrue(nowNs >= 10 * FRAME_NS, () -> "at " + nowNs);
    long afterwardsNs = nowNs;
    clock.awaitDue();
    assertEquals(afterwardsNs, nowNs);
  }

  @Test
  void anInterruptEndsIt() {
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, () -> new VirtualClock().awaitDue());
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, () -> new VirtualClock().awaitDue(() -> true));
  }
}
