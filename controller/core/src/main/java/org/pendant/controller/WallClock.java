package org.pendant.controller;

import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.pendant.models.time.FrameTime;

/**
 * Wall clock: a frame every 2 ms of real time, or faster or slower by a factor. A delay is caught
 * up at twice the pace, unless it is so long (a computer that slept) that it is dropped.
 */
public final class WallClock implements Clock {
  private static final long REAL_FRAME_NS = Math.round(FrameTime.FRAME_S * 1e9);

  private final long frameNs;
  private final LongSupplier nanoTime;
  private final Deadlines deadlines = new Deadlines();

  /**
   * How punctual the frames were.
   *
   * @param frames how many there were
   * @param lateFrames how many began more than 1 ms after their deadline
   * @param worstNs the longest delay, ns
   */
  public record Lateness(long frames, long lateFrames, long worstNs) {}

  /** Real time. */
  public WallClock() {
    this(1);
  }

  /**
   * Real time, {@code factor} times as fast.
   *
   * @throws IllegalArgumentException if the factor is not above 0 and at most 1000
   */
  public WallClock(double factor) {
    this(factor, System::nanoTime);
  }

  WallClock(double factor, LongSupplier nanoTime) {
    frameNs = Math.round(FrameTime.FRAME_S * 1e9 / new Pace.Times(factor).factor());
    this.nanoTime = nanoTime;
  }

  @Override
  public Due awaitDue(BooleanSupplier waitsForOutside) throws InterruptedException {
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
    long nowNs = nanoTime.getAsLong();
    for (long waitNs = deadlines.waitNs(nowNs); waitNs > 0; waitNs = deadlines.waitNs(nowNs)) {
      LockSupport.parkNanos(waitNs);
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      nowNs = nanoTime.getAsLong();
    }
    boolean slowed = frameNs < REAL_FRAME_NS && waitsForOutside.getAsBoolean();
    deadlines.begin(nowNs, slowed ? REAL_FRAME_NS : frameNs);
    return Due.FRAME;
  }

  @Override
  public void startAfresh() {
    deadlines.startAfresh();
  }

  @Override
  public long lostNs() {
    return deadlines.lostNs();
  }

  /** How punctual the frames were so far; any thread. */
  public Lateness lateness() {
    return deadlines.lateness();
  }
}
