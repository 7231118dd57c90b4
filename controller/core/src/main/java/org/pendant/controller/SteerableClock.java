package org.pendant.controller;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.LongConsumer;
import java.util.function.LongSupplier;
import org.pendant.models.time.FrameTime;

/**
 * Steerable clock: its pace can be changed while it runs. One thread waits, any thread steers.
 *
 * <p>To be woken for each frame costs far more than a frame in which nothing happens. So while
 * frames may be {@linkplain #gatherWhile gathered}, it lets them become due for {@link #GATHER_NS},
 * and has them run one after the other then. A command ends that at once: the frames whose time is
 * over are run without it, and it comes into force in the frame that it would have come into force
 * in otherwise.
 */
public final class SteerableClock implements Clock {
  /**
   * So long frames are gathered. Those that follow each other find in the processor's caches what
   * the first of them has fetched; and they are made up for in two milliseconds when a command
   * arrives.
   */
  static final long GATHER_NS = TimeUnit.MILLISECONDS.toNanos(250);

  private static final Optional<Due> NOTHING = Optional.empty();
  private static final Optional<Due> FRAME = Optional.of(Due.FRAME);
  private static final Optional<Due> EARLIER_FRAME = Optional.of(Due.EARLIER_FRAME);
  private static final Optional<Due> COMMANDS = Optional.of(Due.COMMANDS);

  private final LongSupplier nanoTime;
  private final LongConsumer parkNanos;
  private final Deadlines deadlines = new Deadlines();
  private final AtomicInteger grantedFrames = new AtomicInteger();
  private volatile Pace pace;
  private volatile boolean commandWaits;
  private volatile boolean gathering;
  private volatile Thread waiting;
  private Pace followed;
  private BooleanSupplier mayGather = () -> false;

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
    if (gathering || pace instanceof Pace.Paused) {
      LockSupport.unpark(waiting);
    }
  }

  @Override
  public void gatherWhile(BooleanSupplier mayGather) {
    this.mayGather = mayGather;
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
    if (due.get() != Due.EARLIER_FRAME) {
      // cleared before the commands are taken, so that one that comes meanwhile is not overlooked
      commandWaits = false;
    }
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

  private Optional<Due> dueAt(double factor) {
    long nowNs = nanoTime.getAsLong();
    long waitNs = deadlines.waitNs(nowNs);
    if (waitNs > 0) {
      if (!commandWaits && mayGather.getAsBoolean()) {
        gather(nowNs + waitNs + GATHER_NS);
      } else {
        parkNanos.accept(waitNs);
      }
      return NOTHING;
    }
    Optional<Due> due = deadlines.gathered() ? EARLIER_FRAME : FRAME;
    deadlines.begin(nowNs, Math.round(FrameTime.FRAME_S * 1e9 / factor));
    return due;
  }

  /** Lets frames become due, until a command arrives at most. */
  private void gather(long untilNs) {
    gathering = true;
    if (!commandWaits) {
      parkNanos.accept(untilNs - nanoTime.getAsLong());
    }
    gathering = false;
    long nowNs = nanoTime.getAsLong();
    deadlines.gather(nowNs - untilNs < 0 ? nowNs : untilNs);
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
