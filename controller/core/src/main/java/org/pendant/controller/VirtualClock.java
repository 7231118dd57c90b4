package org.pendant.controller;

import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import org.pendant.models.time.FrameTime;

/**
 * Virtual clock: the next frame is due immediately, so that frames follow as fast as the processor
 * computes them. While a reply from outside is waited for, frames are due every 2 ms of real time:
 * a timeout would otherwise be over before anybody can answer.
 */
public final class VirtualClock implements Clock {
  private static final long FRAME_NS = Math.round(FrameTime.FRAME_S * 1e9);

  private final Deadlines deadlines = new Deadlines();
  private final LongSupplier nanoTime;
  private boolean paced;

  /** As fast as the processor goes. */
  public VirtualClock() {
    this(System::nanoTime);
  }

  VirtualClock(LongSupplier nanoTime) {
    this.nanoTime = nanoTime;
  }

  @Override
  public Due awaitDue(BooleanSupplier waitsForOutside) throws InterruptedException {
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
    boolean wasPaced = paced;
    paced = waitsForOutside.getAsBoolean();
    if (paced) {
      if (!wasPaced) {
        deadlines.startAfresh();
      }
      awaitDeadline();
    }
    return Due.FRAME;
  }

  @Override
  public void startAfresh() {
    deadlines.startAfresh();
  }

  @Override
  public long lostNs() {
    return 0;
  }

  private void awaitDeadline() throws InterruptedException {
    long nowNs = nanoTime.getAsLong();
    for (long waitNs = deadlines.waitNs(nowNs); waitNs > 0; waitNs = deadlines.waitNs(nowNs)) {
      LockSupport.parkNanos(waitNs);
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      nowNs = nanoTime.getAsLong();
    }
    deadlines.begin(nowNs, FRAME_NS);
  }
}
