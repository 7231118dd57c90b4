package org.pendant.controller;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.LongSupplier;
import org.pendant.controller.motion.FrameTime;

/**
 * A frame every 2 ms of real time, or faster or slower by a factor. Frames that come late are
 * caught up without a wait, unless the delay is so long (a computer that slept) that it is dropped.
 */
public final class WallClock implements Clock {
  /** Delay in ns beyond which the deadlines start afresh. */
  private static final long GIVE_UP_NS = TimeUnit.MILLISECONDS.toNanos(200);

  /** A frame that starts at most this much (ns) after its deadline is on time. */
  private static final long ON_TIME_NS = TimeUnit.MILLISECONDS.toNanos(1);

  private final long frameNs;
  private final LongSupplier nanoTime;
  private boolean started;
  private long dueNs;
  private long frames;
  private long lateFrames;
  private long worstNs;
  private volatile Lateness lateness = new Lateness(0, 0, 0);

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
    if (!(factor > 0 && factor <= 1000)) {
      throw new IllegalArgumentException(
          "speed factor is " + factor + ", must be above 0 and at most 1000");
    }
    frameNs = Math.round(FrameTime.FRAME_S * 1e9 / factor);
    this.nanoTime = nanoTime;
  }

  @Override
  public void awaitFrame() throws InterruptedException {
    long nowNs = nanoTime.getAsLong();
    if (!started) {
      started = true;
      dueNs = nowNs;
    }
    while (nowNs < dueNs) {
      LockSupport.parkNanos(dueNs - nowNs);
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      nowNs = nanoTime.getAsLong();
    }
    note(nowNs - dueNs);
    dueNs = nowNs - dueNs > GIVE_UP_NS ? nowNs + frameNs : dueNs + frameNs;
  }

  private void note(long lateNs) {
    frames++;
    if (lateNs > ON_TIME_NS) {
      lateFrames++;
    }
    worstNs = Math.max(worstNs, lateNs);
    lateness = new Lateness(frames, lateFrames, worstNs);
  }

  /** How punctual the frames were so far; any thread. */
  public Lateness lateness() {
    return lateness;
  }
}
