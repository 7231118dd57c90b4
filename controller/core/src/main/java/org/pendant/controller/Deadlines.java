package org.pendant.controller;

import java.util.concurrent.TimeUnit;

/**
 * Deadlines of frames: when frames are due, and how late they were. Frames after a late one follow
 * each other twice as fast until the delay is caught up, unless it is so long (a computer that
 * slept) that it is dropped: robot time has lost it then.
 */
final class Deadlines {
  /** Delay in ns beyond which the deadlines start afresh. */
  private static final long GIVE_UP_NS = TimeUnit.MILLISECONDS.toNanos(200);

  /** How much faster frames follow each other while a delay is caught up. */
  private static final int CATCHING_UP = 2;

  /** A frame that starts at most this much (ns) after its deadline is on time. */
  private static final long ON_TIME_NS = TimeUnit.MILLISECONDS.toNanos(1);

  private boolean started;
  private boolean gathering;
  private long gatheredUntilNs;
  private long dueNs;
  private long earliestNs;
  private long frames;
  private long lateFrames;
  private long worstNs;
  private long lostNs;
  private volatile WallClock.Lateness lateness = new WallClock.Lateness(0, 0, 0);

  /** The next frame is due whenever it comes. */
  void startAfresh() {
    started = false;
    gathering = false;
  }

  /**
   * Frames that are due up to {@code untilNs} were let become due on purpose: they follow each
   * other at once, and none of them is late.
   */
  void gather(long untilNs) {
    gathering = true;
    gatheredUntilNs = untilNs;
  }

  /** Whether the next frame is one of those. */
  boolean gathered() {
    return started && gathering && dueNs - gatheredUntilNs <= 0;
  }

  /** How long the next frame has to wait, ns; 0 or less when it is due. */
  long waitNs(long nowNs) {
    if (!started) {
      started = true;
      dueNs = nowNs;
      earliestNs = nowNs;
    }
    return gathered() ? 0 : Math.max(dueNs, earliestNs) - nowNs;
  }

  /** A frame that lasts {@code frameNs} begins. */
  void begin(long nowNs, long frameNs) {
    frames++;
    if (gathered()) {
      lateness = new WallClock.Lateness(frames, lateFrames, worstNs);
      dueNs += frameNs;
      earliestNs = dueNs;
      return;
    }
    long lateNs = nowNs - dueNs;
    if (lateNs > ON_TIME_NS) {
      lateFrames++;
    }
    worstNs = Math.max(worstNs, lateNs);
    lateness = new WallClock.Lateness(frames, lateFrames, worstNs);
    earliestNs = nowNs + frameNs / CATCHING_UP;
    if (lateNs > GIVE_UP_NS) {
      lostNs += lateNs;
      dueNs = nowNs + frameNs;
    } else {
      dueNs += frameNs;
    }
  }

  /** What was dropped so far, ns; for the thread that waits. */
  long lostNs() {
    return lostNs;
  }

  /** How punctual the frames were so far; any thread. */
  WallClock.Lateness lateness() {
    return lateness;
  }
}
