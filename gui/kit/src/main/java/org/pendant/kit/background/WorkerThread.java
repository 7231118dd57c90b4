package org.pendant.kit.background;

import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.pendant.kit.fault.Faults;

/** Worker thread that does what would block the window. It does not keep the program alive. */
public final class WorkerThread implements WorkQueue {
  private final ScheduledExecutorService executor;

  /** A thread of this name, waiting for work. */
  public WorkerThread(String name) {
    executor =
        Executors.newSingleThreadScheduledExecutor(
            Thread.ofPlatform().daemon().name(name).factory());
  }

  @Override
  public void run(int delayMs, Runnable work) {
    // The executor would keep a fault to itself: it belongs to the handler of uncaught faults.
    var _ = executor.schedule(() -> Faults.guard(work), delayMs, TimeUnit.MILLISECONDS);
  }
}
