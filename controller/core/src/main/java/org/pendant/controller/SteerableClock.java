package org.pendant.controller;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import org.pendant.models.time.FrameTime;

/** A clock whose pace can be changed while it runs. One thread waits, any thread steers. */
public final class SteerableClock implements Clock {
  private final LongSupplier nanoTime;
  private final LongConsumer parkNanos;
  private final Deadlines deadlines = new Deadlines();
  private final AtomicInteger grantedFrames = new AtomicInteger();
  private volatile Pace pace;
  private volatile boolean commandWaits;
  private volatile Thread waiting;
  private Pace followed;

  /** A clock that starts with {@code pace}. */
  public SteerableClock(Pace pace) {
    this(pace, System::nanoTime, LockSupport::parkNanos);
  }

  /**
   * @param parkNanos waits so many ns, or less
   */
  SteerableClock(Pace pace, LongSupplier nanoTime, LongConsumer parkNanos) {
    this.pace = pace;
    this.nanoTime = nanoTime;
    this.parkNanos = parkNanos;
    followed = pace;
  }

  /** How robot time goes by now. */
  public Pace pace() {
    return pace;
  }

  /** Changes the pace, from the next frame on. Frames that were granted and not begun lapse. */
  public void setPace(Pace wanted) {
    grantedFrames.set(0);
    pace = wanted;
    LockSupport.unpark(waiting);
  }

  /** Lets {@code count} frames pass while robot time is paused; otherwise nothing happens. */
  public void grant(int count) {
    if (pace instanceof Pace.Paused) {
      grantedFrames.addAndGet(count);
      LockSupport.unpark(waiting);
    }
  }

  /**
   * Says that a command has been left for the next frame. One frame passes for it even if robot
   * time is paused: nothing else carries commands out.
   */
  public void commandArrived() {
    commandWaits = true;
    LockSupport.unpark(waiting);
  }

  @Override
  public void awaitFrame(BooleanSupplier waitsForOutside) throws InterruptedException {
    waiting = Thread.currentThread();
    while (!frameIsDue(waitsForOutside)) {
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
    }
    // Cleared before the frame takes its commands, so one that comes meanwhile asks for another.
    commandWaits = false;
  }

  /** Whether the next frame may begin; if not, some time has passed. */
  private boolean frameIsDue(BooleanSupplier waitsForOutside) {
    Pace wanted = pace;
    if (fasterThanReal(wanted) && waitsForOutside.getAsBoolean()) {
      wanted = Pace.REAL_TIME;
    }
    if (!wanted.equals(followed)) {
      followed = wanted;
      deadlines.startAfresh();
    }
    return switch (wanted) {
      case Pace.Unlimited unlimited -> !Thread.currentThread().isInterrupted();
      case Pace.Paused paused -> grantedWhilePaused();
      case Pace.Times times -> dueAt(times.factor());
    };
  }

  private static boolean fasterThanReal(Pace wanted) {
    return switch (wanted) {
      case Pace.Unlimited unlimited -> true;
      case Pace.Paused paused -> false;
      case Pace.Times times -> times.factor() > 1;
    };
  }

  private boolean grantedWhilePaused() {
    if (commandWaits) {
      return true;
    }
    if (grantedFrames.get() > 0) {
      grantedFrames.decrementAndGet();
      return true;
    }
    parkNanos.accept(Long.MAX_VALUE);
    return false;
  }

  private boolean dueAt(double factor) {
    long nowNs = nanoTime.getAsLong();
    long waitNs = deadlines.waitNs(nowNs);
    if (waitNs > 0) {
      parkNanos.accept(waitNs);
      return false;
    }
    deadlines.begin(nowNs, Math.round(FrameTime.FRAME_S * 1e9 / factor));
    return true;
  }

  @Override
  public void startAfresh() {
    deadlines.startAfresh();
  }

  @Override
  public long lostNs() {
    return deadlines.lostNs();
  }

  /** How punctual the frames were at paces that are a multiple of real time; any thread. */
  public WallClock.Lateness lateness() {
    return deadlines.lateness();
  }
}
