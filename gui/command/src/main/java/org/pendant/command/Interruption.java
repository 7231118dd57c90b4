package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;

/**
 * Interruption: Ctrl-C and SIGTERM, as a flag that the run looks at every frame.
 *
 * <p>The JVM answers a signal by running its shutdown hooks and then exiting with 128 + the
 * signal's number. The hook here holds that up until what is under way has stopped the arm and
 * written everything, so nothing is lost and the exit code is the usual one. A second signal ends
 * the process at once.
 */
final class Interruption implements AutoCloseable {
  /** A run that has not ended by then never will. */
  private static final int PATIENCE_S = 10;

  private final String what;
  private final int patienceS;
  private final CountDownLatch wanted = new CountDownLatch(1);
  private final CountDownLatch ended = new CountDownLatch(1);
  private volatile Optional<ExitCode> exitCode = Optional.empty();
  private volatile boolean held;

  private Interruption(String what, int patienceS) {
    this.what = what;
    this.patienceS = patienceS;
  }

  /**
   * Begins to listen. A signal ends the process at once until {@link #hold} is called.
   *
   * @param what is under way then, the key of a text such as {@code theRun}
   */
  static Interruption listen(String what) {
    return listen(what, PATIENCE_S);
  }

  /**
   * As {@link #listen(String)}, for what may take longer to end.
   *
   * @param patienceS after which the process ends in any case
   */
  static Interruption listen(String what, int patienceS) {
    Interruption interruption = new Interruption(what, patienceS);
    Runtime.getRuntime().addShutdownHook(new Thread(interruption::shutDown, "interruption"));
    return interruption;
  }

  /**
   * The end of a stream counts as a signal: it comes when the process that holds its other end
   * wants so, and when that has gone.
   */
  void listenToEndOf(InputStream in) {
    Thread.ofPlatform()
        .daemon()
        .name("end of input")
        .start(
            () -> {
              try {
                in.transferTo(OutputStream.nullOutputStream());
              } catch (IOException e) {
                // nobody is there any more either
              }
              wanted.countDown();
              if (!held) {
                Runtime.getRuntime().exit(ExitCode.UNAVAILABLE.number());
              }
            });
  }

  /** From now on something is under way that has to be brought to its end. */
  void hold() {
    held = true;
  }

  /** What was under way is over, and everything is written. */
  void release() {
    held = false;
  }

  /** Whether the user wants the run to end. */
  boolean requested() {
    return wanted.getCount() == 0;
  }

  /** Waits until the user does, or for {@code timeMs}; answers whether the user does. */
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
    if (!held) {
      return;
    }
    try {
      if (signalled) {
        letNextSignalEnd();
      }
      if (!ended.await(patienceS, TimeUnit.SECONDS)) {
        System.err.println(text("didNotEnd", text(what), patienceS));
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
   * The JVM itself would ignore another signal. What it offers for that has no replacement, and
   * javac warns of it in a way that cannot be suppressed; where it is gone, nothing changes.
   */
  private static void letNextSignalEnd() {
    try {
      Class<?> signal = Class.forName("sun.misc.Signal");
      Class<?> handler = Class.forName("sun.misc.SignalHandler");
      Object byDefault = handler.getField("SIG_DFL").get(null);
      for (String name : List.of("INT", "TERM")) {
        Object each = signal.getConstructor(String.class).newInstance(name);
        signal.getMethod("handle", signal, handler).invoke(null, each, byDefault);
      }
    } catch (ReflectiveOperationException e) {
      System.err.println(text("signalNotHeeded", e));
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
