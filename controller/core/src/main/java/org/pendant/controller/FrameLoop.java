package org.pendant.controller;

import java.util.Optional;

/** A thread that drives a controller at the pace of a clock until it is closed. */
public final class FrameLoop implements AutoCloseable {
  /** How often a held frame looks for commands, ms. */
  private static final long HELD_MS = 2;

  private static final double NS = 1e-9;

  private final Controller controller;
  private final Clock clock;
  private final Runnable afterEach;
  private final Thread thread;
  private long toldLostNs;
  private volatile boolean closing;
  private volatile Optional<Throwable> failure = Optional.empty();

  private FrameLoop(Controller controller, Clock clock, Runnable afterEach) {
    this.controller = controller;
    this.clock = clock;
    this.afterEach = afterEach;
    thread = Thread.ofPlatform().daemon().name("frame loop").unstarted(this::run);
  }

  /** Starts driving; nobody else may from now on. */
  public static FrameLoop start(Controller controller, Clock clock) {
    return start(controller, clock, () -> {});
  }

  /**
   * As {@link #start(Controller, Clock)}.
   *
   * @param afterEach runs in the loop's thread after each frame, and must be short
   */
  public static FrameLoop start(Controller controller, Clock clock, Runnable afterEach) {
    FrameLoop loop = new FrameLoop(controller, clock, afterEach);
    loop.thread.start();
    return loop;
  }

  private void run() {
    try {
      while (!closing) {
        clock.awaitFrame(controller::waitsForOutside);
        tellLost();
        controller.advance();
        afterEach.run();
        if (controller.state().debug().held()) {
          // time stands still; only commands are waited for
          Thread.sleep(HELD_MS);
          clock.startAfresh();
        }
      }
    } catch (InterruptedException e) {
      // close() asked for it
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      failure = Optional.of(e);
    }
  }

  /** As a command, so that a run that is repeated hears of it at the same place. */
  private void tellLost() {
    if (clock.lostNs() != toldLostNs) {
      toldLostNs = clock.lostNs();
      var _ = controller.submit(new Command.NoteLostTime(NS * toldLostNs));
    }
  }

  /** What ended the loop although nobody closed it. */
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
