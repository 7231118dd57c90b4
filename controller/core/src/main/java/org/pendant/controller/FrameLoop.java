package org.pendant.controller;

import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * Frame loop: a thread that drives a controller, or a cell of them, at the pace of a clock until it
 * is closed.
 */
public final class FrameLoop implements AutoCloseable {
  /** How often a held frame is shown to those who follow each frame, ns. */
  private static final long HELD_NS = TimeUnit.MILLISECONDS.toNanos(2);

  /** How often it looks around while nobody does; a command ends the wait. */
  private static final long HELD_ALONE_NS = TimeUnit.MILLISECONDS.toNanos(50);

  private static final double NS = 1e-9;

  private final Frames frames;
  private final Clock clock;
  private final Runnable afterEach;
  private final Thread thread;
  private long toldLostNs;
  private volatile boolean closing;
  private volatile Optional<Throwable> failure = Optional.empty();

  private FrameLoop(Frames frames, Clock clock, Runnable afterEach) {
    this.frames = frames;
    this.clock = clock;
    this.afterEach = afterEach;
    thread = Thread.ofPlatform().daemon().name("frame loop").unstarted(this::run);
  }

  /** Starts driving; no other thread may from now on. */
  public static FrameLoop start(Frames frames, Clock clock) {
    return start(frames, clock, () -> {});
  }

  /**
   * As {@link #start(Frames, Clock)}.
   *
   * @param afterEach runs in the loop's thread after each frame, and must be short
   */
  public static FrameLoop start(Frames frames, Clock clock, Runnable afterEach) {
    FrameLoop loop = new FrameLoop(frames, clock, afterEach);
    loop.thread.start();
    return loop;
  }

  private void run() {
    frames.wakeBy(this::commandArrived);
    clock.gatherWhile(frames::needsNoFrameOnTime);
    // those that came before
    clock.commandArrived();
    try {
      while (!closing) {
        Clock.Due due = clock.awaitDue(frames::waitsForOutside);
        tellLost();
        switch (due) {
          case FRAME -> frames.advance();
          case EARLIER_FRAME -> frames.advanceBeforeCommands();
          case COMMANDS -> frames.applyCommands();
        }
        afterEach.run();
        if (frames.held()) {
          hold();
        }
      }
    } catch (InterruptedException e) {
      // close() asked for it
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      failure = Optional.of(e);
    }
  }

  private void commandArrived() {
    clock.commandArrived();
    LockSupport.unpark(thread);
  }

  /** Time stands still; only commands are waited for. */
  private void hold() throws InterruptedException {
    LockSupport.parkNanos(frames.followed() ? HELD_NS : HELD_ALONE_NS);
    if (Thread.interrupted()) {
      throw new InterruptedException();
    }
    clock.startAfresh();
  }

  private void tellLost() {
    if (clock.lostNs() != toldLostNs) {
      toldLostNs = clock.lostNs();
      frames.noteLostTime(NS * toldLostNs);
    }
  }

  /** What ended the loop although it was not closed. */
  public Optional<Throwable> failure() {
    return failure;
  }

  /** Stops after the running frame and waits for its end. */
  @Override
  public void close() {
    closing = true;
    thread.interrupt();
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
