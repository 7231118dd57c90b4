package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;

final class SteerableClockTest {
  private static final long FRAME_NS = 2_000_000;

  private long nowNs = 1_000;
  private int parks;
  private Runnable whileParked = () -> {};

  private SteerableClock clock(Pace pace) {
    return new SteerableClock(pace, () -> nowNs, this::park);
  }

  /** Waiting lets the fake time pass, and lets other threads run. */
  private void park(long ns) {
    parks++;
    if (ns < Long.MAX_VALUE) {
      nowNs += ns;
    }
    whileParked.run();
  }

  private static void await(SteerableClock clock, int frames) throws InterruptedException {
    for (int i = 0; i < frames; i++) {
      clock.awaitDue();
    }
  }

  @Test
  void inRealTimeAFrameComesEveryTwoMilliseconds() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    await(clock, 501);
    assertEquals(1_000 + 500 * FRAME_NS, nowNs);
    assertEquals(new WallClock.Lateness(501, 0, 0), clock.lateness());
  }

  @Test
  void aDelayIsCaughtUpAtTwiceThePace() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    await(clock, 1);
    nowNs += 50 * FRAME_NS;
    long backNs = nowNs;
    await(clock, 49);
    assertEquals(48 * FRAME_NS / 2, nowNs - backNs);
    await(clock, 51);
    assertEquals(1_000 + 100 * FRAME_NS, nowNs);
    assertEquals(0, clock.lostNs());
  }

  @Test
  void aFactorShortensTheFrames() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Times(4));
    await(clock, 401);
    assertEquals(1_000 + 100 * FRAME_NS, nowNs);
  }

  @Test
  void theFactorCanBeChangedOnTheWay() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    await(clock, 11);
    clock.setPace(new Pace.Times(2));
    await(clock, 11);
    assertEquals(1_000 + 10 * FRAME_NS + 10 * FRAME_NS / 2, nowNs);
  }

  @Test
  void withoutALimitNothingWaits() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Unlimited());
    await(clock, 1000);
    assertEquals(1_000, nowNs);
    assertEquals(0, parks);
  }

  @Test
  void whileSomebodyOutsideIsWaitedForTimeGoesNoFasterThanReal() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Unlimited());
    for (int i = 0; i < 11; i++) {
      clock.awaitDue(() -> true);
    }
    assertEquals(1_000 + 10 * FRAME_NS, nowNs);
    await(clock, 100);
    assertEquals(1_000 + 10 * FRAME_NS, nowNs);
    clock.setPace(new Pace.Times(0.5));
    for (int i = 0; i < 11; i++) {
      clock.awaitDue(() -> true);
    }
    assertEquals(1_000 + 30 * FRAME_NS, nowNs);
  }

  @Test
  void whilePausedEachGrantLetsOneFramePass() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Paused());
    whileParked = () -> clock.grant(1);
    await(clock, 3);
    assertEquals(3, parks);
  }

  @Test
  void whilePausedCommandsAreDueWithoutAFrame() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Paused());
    clock.commandArrived();
    assertEquals(Clock.Due.COMMANDS, clock.awaitDue());
    assertEquals(0, parks);
    whileParked = clock::commandArrived;
    assertEquals(Clock.Due.COMMANDS, clock.awaitDue());
    assertEquals(1, parks);
  }

  @Test
  void aGrantedFrameTakesTheCommandsWithIt() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Paused());
    clock.commandArrived();
    clock.grant(1);
    assertEquals(Clock.Due.FRAME, clock.awaitDue());
  }

  @Test
  void grantsThatWereNotUsedLapseWithAChangeOfPace() throws InterruptedException {
    SteerableClock clock = clock(new Pace.Paused());
    clock.grant(5);
    clock.setPace(new Pace.Paused());
    whileParked = () -> clock.setPace(Pace.REAL_TIME);
    clock.awaitDue();
    assertEquals(1, parks);
  }

  @Test
  void aPauseDoesNotCountAsLateness() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    await(clock, 2);
    clock.setPace(new Pace.Paused());
    nowNs += 150_000_000;
    clock.grant(1);
    clock.awaitDue();
    clock.setPace(Pace.REAL_TIME);
    await(clock, 2);
    assertEquals(0, clock.lateness().lateFrames());
  }

  @Test
  void framesThatNobodyNeedsOnTimeComeSomeTogether() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    clock.gatherWhile(() -> true);
    assertEquals(Clock.Due.FRAME, clock.awaitDue());
    int gathered = (int) (SteerableClock.GATHER_NS / FRAME_NS) + 1;
    for (int i = 0; i < 10 * gathered; i++) {
      assertEquals(Clock.Due.EARLIER_FRAME, clock.awaitDue());
    }
    assertEquals(10, parks);
    assertEquals(1_000 + 10L * gathered * FRAME_NS, nowNs);
    assertEquals(new WallClock.Lateness(10L * gathered + 1, 0, 0), clock.lateness());
  }

  @Test
  void aCommandComesIntoForceInTheFrameInWhichItWouldHaveAnyway() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    clock.gatherWhile(() -> true);
    clock.awaitDue();
    whileParked =
        () -> {
          // the park lasted until then instead
          nowNs = 1_000 + 5 * FRAME_NS + FRAME_NS / 2;
          whileParked = () -> {};
          clock.commandArrived();
        };
    for (int frame = 1; frame <= 5; frame++) {
      assertEquals(Clock.Due.EARLIER_FRAME, clock.awaitDue(), "frame " + frame);
    }
    assertEquals(1, parks);
    assertEquals(Clock.Due.FRAME, clock.awaitDue());
    assertEquals(1_000 + 6 * FRAME_NS, nowNs);
    assertEquals(0, clock.lateness().lateFrames());
  }

  @Test
  void aCommandThatIsThereKeepsFramesFromBeingGathered() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    clock.gatherWhile(() -> true);
    clock.awaitDue();
    clock.commandArrived();
    assertEquals(Clock.Due.FRAME, clock.awaitDue());
    assertEquals(1_000 + FRAME_NS, nowNs);
  }

  @Test
  void aComputerThatSleptWhileFramesWereGatheredIsLate() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    clock.gatherWhile(() -> true);
    clock.awaitDue();
    whileParked =
        () -> {
          nowNs += 1_000_000_000L;
          whileParked = () -> {};
        };
    await(clock, (int) (SteerableClock.GATHER_NS / FRAME_NS) + 2);
    assertEquals(1, clock.lateness().lateFrames());
    assertEquals(1_000_000_000L - FRAME_NS, clock.lostNs());
  }

  @Test
  void aChangeOfPaceDropsWhatWasGathered() throws InterruptedException {
    SteerableClock clock = clock(Pace.REAL_TIME);
    clock.gatherWhile(() -> true);
    clock.awaitDue();
    whileParked = () -> clock.setPace(new Pace.Times(2));
    assertEquals(Clock.Due.FRAME, clock.awaitDue());
    assertEquals(1, parks);
  }

  @Test
  void anInterruptEndsTheWait() {
    SteerableClock clock = clock(new Pace.Paused());
    whileParked = () -> Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, clock::awaitDue);
    Thread.currentThread().interrupt();
    assertThrows(InterruptedException.class, clock(new Pace.Unlimited())::awaitDue);
  }

  @Test
  void factorsOutOfRangeAreRefused() {
    assertEquals(
        "speed factor is 0.0, must be above 0 and at most 1000",
        assertThrows(IllegalArgumentException.class, () -> new Pace.Times(0)).getMessage());
    assertThrows(IllegalArgumentException.class, () -> new Pace.Times(1001));
    assertThrows(IllegalArgumentException.class, () -> new Pace.Times(Double.NaN));
  }
}
