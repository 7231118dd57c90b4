package org.pendant.controller;

import java.util.Optional;

/** A thread that drives a controller at the pace of a clock until it is closed. */
public final class FrameLoop implements AutoCloseable {
  private final Controller controller;
  private final Clock clock;
  private final Thread thread;
  private volatile boolean closing;
  private volatile Optional<Throwable> failure = Optional.empty();

  private FrameLoop(Controller controller, Clock clock) {
    this.controller = controller;
    this.clock = clock;
    thread = Thread.ofPlatform().daemon().name("frame loop").unstarted(this::run);
  }

  /** Starts driving; nobody else may from now on. */
  public static FrameLoop start(Controller controller, Clock clock) {
    FrameLoop loop = new FrameLoop(controller, clock);
    loop.thread.start();
    return loop;
  }

  private void run() {
    try {
      while (!closing) {
        clock.awaitFrame();
        controller.advance();
      }
    } catch (InterruptedException e) {
      // close() asked for it
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      failure = Optional.of(e);
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
