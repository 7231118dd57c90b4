package org.pendant.controller;

import java.util.concurrent.TimeUnit;

/**
 * When frames are due, and how late they were. A late frame does not delay those after it, unless
 * it is so late (a computer that slept) that the deadlines start afresh.
 */
final class Deadlines {
  /** Delay in ns beyond which the deadlines start afresh. */
  private static final long GIVE_UP_NS = TimeUnit.MILLISECONDS.toNanos(200);

  /** A frame that starts at most this much (ns) after its deadline is on time. */
  private static final long ON_TIME_NS = TimeUnit.MILLISECONDS.toNanos(1);

  private boolean started;
  private long dueNs;
  private long frames;
  private long lateFrames;
  private long worstNs;
  private volatile WallClock.Lateness lateness = new WallClock.Lateness(0, 0, 0);

  /** The next frame is due whenever it comes. */
  void startAfresh() {
    started = false;
  }

  /** How long the next frame has to wait, ns; 0 or less when it is due. */
  long waitNs(long nowNs) {
    if (!started) {
      started = true;
      dueNs = nowNs;
    }
    return dueNs - nowNs;
  }

  /** A frame that lasts {@code frameNs} begins. */
  void begin(long nowNs, long frameNs) {
    long lateNs = nowNs - dueNs;
    frames++;
    if (lateNs > ON_TIME_NS) {
      lateFrames++;
    }
    worstNs = Math.max(worstNs, lateNs);
    lateness = new WallClock.Lateness(frames, lateFrames, worstNs);
    dueNs = lateNs > GIVE_UP_NS ? nowNs + frameNs : dueNs + frameNs;
  }

  /** How punctual the frames were so far; any thread. */
  WallClock.Lateness lateness() {
    return lateness;
  }
}
