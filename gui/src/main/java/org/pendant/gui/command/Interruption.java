package org.pendant.gui.command;

import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Ctrl-C and SIGTERM, as a flag that the run looks at every frame.
 *
 * <p>The JVM answers a signal by running its shutdown hooks and then exiting with 128 + the
 * signal's number. The hook here holds that up until the run has stopped the arm and written
 * everything, so nothing is lost and the exit code is the usual one.
 */
final class Interruption implements AutoCloseable {
  /** A run that has not ended by then never will. */
  private static final int PATIENCE_S = 10;

  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile boolean requested;

  private Interruption() {}

  /** Begins to listen. */
  static Interruption listen() {
    Interruption interruption = new Interruption();
    Runtime.getRuntime().addShutdownHook(new Thread(interruption::shutDown, "interruption"));
    return interruption;
  }

  /** Whether somebody wants the run to end. */
  boolean requested() {
    return requested;
  }

  private void shutDown() {
    requested = true;
    try {
      if (!ended.await(PATIENCE_S, TimeUnit.SECONDS)) {
        System.err.println("pendant: the run did not end within " + PATIENCE_S + " s");
      }
    } catch (InterruptedException e) {
      // The process ends either way.
      Thread.currentThread().interrupt();
    }
  }

  /** The run has ended and everything is written: the process may go. */
  @Override
  public void close() {
    ended.countDown();
  }
}
