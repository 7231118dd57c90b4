package org.pendant.protocols.net;

import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/**
 * Periodic tasks, which run again and again, all in one thread. One that throws is logged and runs
 * again at its next time ({@link FaultGuard}): a watchdog must not end by its own fault.
 */
public final class PeriodicTasks implements AutoCloseable {
  private final PeerLog log;
  private final ScheduledThreadPoolExecutor timer;

  /**
   * None yet.
   *
   * @param thread what kind of thread runs them
   */
  public PeriodicTasks(Thread.Builder thread, PeerLog log) {
    this.log = log;
    timer = new ScheduledThreadPoolExecutor(1, thread.factory());
    timer.setRemoveOnCancelPolicy(true);
  }

  /**
   * Begins to run {@code task} at a rate.
   *
   * @param what it is, for the log
   * @param intervalNs from begin to begin, and before the first time, above 0
   * @return ends it, unless it is just running
   */
  public Runnable atRate(String what, long intervalNs, Runnable task) {
    Future<?> running =
        timer.scheduleAtFixedRate(
            guarded(what, task), intervalNs, intervalNs, TimeUnit.NANOSECONDS);
    return () -> running.cancel(false);
  }

  /**
   * Begins to run {@code task} with pauses, which a slow machine does not make up for.
   *
   * @param what it is, for the log
   * @param pauseNs from end to begin, and before the first time, above 0
   * @return ends it, unless it is just running
   */
  public Runnable withPauses(String what, long pauseNs, Runnable task) {
    Future<?> running =
        timer.scheduleWithFixedDelay(guarded(what, task), pauseNs, pauseNs, TimeUnit.NANOSECONDS);
    return () -> running.cancel(false);
  }

  private Runnable guarded(String what, Runnable task) {
    FaultGuard guard = new FaultGuard(what, log);
    return () -> guard.run(task);
  }

  /** Ends all of them; does not wait for one that runs. */
  @Override
  public void close() {
    timer.shutdownNow();
  }
}
