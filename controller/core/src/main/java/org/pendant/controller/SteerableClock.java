package org.pendant.controller;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import org.pendant.models.time.FrameTime;

/** Steerable clock: its pace can be changed while it runs. One thread waits, any thread steers. */
public final class SteerableClock implements Clock {
  private static final Optional<Due> NOTHING = Optional.empty();
  private static final Optional<Due> FRAME = Optional.of(Due.FRAME);
  private static final Optional<Due> COMMANDS = Optional.of(Due.COMMANDS);

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

  @Override
  public void commandArrived() {
    commandWaits = true;
    if (pace instanceof Pace.Paused) {
      LockSupport.unpark(waiting);
    }
  }

  @Override
  public Due awaitDue(BooleanSupplier waitsForOutside) throws InterruptedException {
    waiting = Thread.currentThread();
    Optional<Due> due = due(waitsForOutside);
    while (due.isEmpty()) {
      if (Thread.interrupted()) {
        throw new InterruptedException();
      }
      due = due(waitsForOutside);
    }
    // cleared before the commands are taken, so that one that comes meanwhile is not overlooked
    commandWaits = false;
    return due.get();
  }

  /** What is due; if nothing is, some time has passed. */
  private Optional<Due> due(BooleanSupplier waitsForOutside) {
    Pace wanted = pace;
    if (fasterThanReal(wanted) && waitsForOutside.getAsBoolean()) {
      wanted = Pace.REAL_TIME;
    }
    if (!wanted.equals(followed)) {
      followed = wanted;
      deadlines.startAfresh();
    }
    return switch (wanted) {
      case Pace.Unlimited unlimited -> Thread.currentThread().isInterrupted() ? NOTHING : FRAME;
      case Pace.Paused paused -> dueWhilePaused();
      case Pace.Times times -> dueAt(times.factor()) ? FRAME : NOTHING;
    };
  }

  private static boolean fasterThanReal(Pace wanted) {
    return switch (wanted) {
      case Pace.Unlimited unlimited -> true;
      case Pace.Paused paused -> false;
      case Pace.Times times -> times.factor() > 1;
    };
  }

  private Optional<Due> dueWhilePaused() {
    if (grantedFrames.get() > 0) {
      grantedFrames.decrementAndGet();
      return FRAME;
    }
    if (commandWaits) {
      return COMMANDS;
    }
    parkNanos.accept(Long.MAX_VALUE);
    return NOTHING;
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
