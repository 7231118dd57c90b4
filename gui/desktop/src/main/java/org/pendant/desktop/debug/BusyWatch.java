package org.pendant.desktop.debug;

import java.util.Optional;
import java.util.function.LongSupplier;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Busy watch: looks now and then whether a thread of a program that runs computes without ever
 * waiting, which makes robot time crawl. It has no Swing; one thread uses it, the dispatch thread.
 */
final class BusyWatch {
  /** Frames without a wait that are told of: a second of robot time. */
  static final int FRAMES = 500;

  private static final long PERIOD_MS = 500;

  private final DebugLink link;
  private final LongSupplier clockMs;
  private Optional<ThreadSnapshot> busy = Optional.empty();
  private long askedMs;
  private boolean asking;

  /**
   * Nothing seen yet.
   *
   * @param clockMs any clock that runs, ms
   */
  BusyWatch(DebugLink link, LongSupplier clockMs) {
    this.link = link;
    this.clockMs = clockMs;
    askedMs = clockMs.getAsLong() - PERIOD_MS;
  }

  /** The first such thread, where it was a moment ago. */
  Optional<ThreadSnapshot> busy() {
    return busy;
  }

  /** Looks if it is time to, while a program {@code runs}. */
  void refresh(boolean runs) {
    if (!runs) {
      busy = Optional.empty();
      return;
    }
    long nowMs = clockMs.getAsLong();
    if (asking || nowMs - askedMs < PERIOD_MS) {
      return;
    }
    asking = true;
    askedMs = nowMs;
    link.ask(
        debugger -> debugger.busyThreads(FRAMES),
        found -> {
          asking = false;
          busy = found.stream().findFirst();
        },
        refused -> asking = false);
  }
}
