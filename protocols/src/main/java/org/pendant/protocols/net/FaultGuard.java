package org.pendant.protocols.net;

import static org.pendant.protocols.net.NetTexts.text;

import java.util.concurrent.atomic.AtomicBoolean;
import org.pendant.controller.message.LogEntry.Level;

/**
 * Fault guard: runs a task that comes again and again, so that a fault in it does not end the
 * thread that the others need as well. The fault is logged, once for all that follow each other.
 * Any thread.
 */
public final class FaultGuard {
  private final String what;
  private final PeerLog log;
  private final AtomicBoolean failing = new AtomicBoolean();

  /**
   * For one task.
   *
   * @param what fails, for the log, such as {@code the watch for silent scanners}
   */
  public FaultGuard(String what, PeerLog log) {
    this.what = what;
    this.log = log;
  }

  /** Runs {@code task}; comes back in any case. */
  public void run(Runnable task) {
    try {
      task.run();
      failing.set(false);
    } catch (RuntimeException | Error e) {
      if (!failing.getAndSet(true)) {
        log.write(Level.ERROR, text("failedAndContinues", what, e));
      }
    }
  }
}
