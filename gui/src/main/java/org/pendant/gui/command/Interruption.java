package org.pendant.gui.command;

import java.util.Optional;
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

  private final CountDownLatch wanted = new CountDownLatch(1);
  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile Optional<ExitCode> exitCode = Optional.empty();

  private Interruption() {}

  /** Begins to listen. */
  static Interruption listen() {
    Interruption interruption = new Interruption();
    Runtime.getRuntime().addShutdownHook(new Thread(interruption::shutDown, "interruption"));
    return interruption;
  }

  /** Whether somebody wants the run to end. */
  boolean requested() {
    return wanted.getCount() == 0;
  }

  /** Waits until somebody does, or for {@code timeMs}; answers whether somebody does. */
  boolean awaitRequest(long timeMs) {
    try {
      return wanted.await(timeMs, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return true;
    }
  }

  private void shutDown() {
    boolean signalled = ended.getCount() > 0;
    wanted.countDown();
    try {
      if (!ended.await(PATIENCE_S, TimeUnit.SECONDS)) {
        System.err.println("pendant: the run did not end within " + PATIENCE_S + " s");
      }
      if (signalled) {
        exitCode.ifPresent(code -> Runtime.getRuntime().halt(code.number()));
      }
    } catch (InterruptedException e) {
      // The process ends either way.
      Thread.currentThread().interrupt();
    }
  }

  /**
   * As {@link #close}, but the process ends with {@code code} even after a signal: for a service
   * this is the way it is meant to end.
   */
  void closeWith(ExitCode code) {
    exitCode = Optional.of(code);
    close();
  }

  /** The run has ended and everything is written: the process may go. */
  @Override
  public void close() {
    ended.countDown();
  }
}
