package org.pendant.kit.fault;

import java.util.function.Consumer;
import javax.swing.Timer;

/** Fault handling: keeps a fault of ours from ending more than the piece of work that made it. */
public final class Faults {
  private Faults() {}

  /**
   * Hands the faults of all threads to {@code file} from now on.
   *
   * @param tell hears of the first of each kind, in any thread
   */
  public static void keepIn(FaultFile file, Consumer<String> tell) {
    Thread.setDefaultUncaughtExceptionHandler(
        (thread, fault) -> file.add(thread.getName(), fault).ifPresent(tell));
  }

  /** Hands a fault to the handler of those of this thread; the thread continues. */
  public static void report(Throwable fault) {
    Thread thread = Thread.currentThread();
    thread.getUncaughtExceptionHandler().uncaughtException(thread, fault);
  }

  /** Runs a part of something, which continues whatever becomes of the part. */
  public static void guard(Runnable part) {
    try {
      part.run();
    } catch (RuntimeException | Error fault) {
      report(fault);
    }
  }

  /**
   * A timer, not started yet, that continues after a fault. One of Swing's own never fires again
   * once its listener has thrown.
   *
   * @param periodMs between two turns
   * @param turn runs on the dispatch thread
   */
  public static Timer timer(int periodMs, Runnable turn) {
    return new Timer(periodMs, event -> guard(turn));
  }
}
