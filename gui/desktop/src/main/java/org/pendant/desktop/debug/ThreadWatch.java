package org.pendant.desktop.debug;

import java.util.List;
import java.util.function.LongSupplier;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Thread watch: looks at the threads of a program that is not paused, twice a second. It has no
 * Swing; one thread uses it, the dispatch thread.
 */
final class ThreadWatch {
  /** Least time between two looks, ms. */
  static final long PERIOD_MS = 500;

  private final DebugLink link;
  private final LongSupplier clockMs;
  private final Runnable changed;
  private List<ThreadSnapshot> threads = List.of();
  private long askedMs;
  private boolean asking;

  /**
   * Nothing seen yet.
   *
   * @param clockMs any clock that runs, ms
   * @param changed told when threads are elsewhere
   */
  ThreadWatch(DebugLink link, LongSupplier clockMs, Runnable changed) {
    this.link = link;
    this.clockMs = clockMs;
    this.changed = changed;
    askedMs = clockMs.getAsLong() - PERIOD_MS;
  }

  /** Where the threads were a moment ago; none while a program is paused or none runs. */
  List<ThreadSnapshot> threads() {
    return threads;
  }

  /** Looks if it is time to; called whenever the user can see the threads. */
  void refresh(ProgramState program, boolean held) {
    if (held || program == ProgramState.STOPPED) {
      show(List.of());
      return;
    }
    long nowMs = clockMs.getAsLong();
    if (asking || nowMs - askedMs < PERIOD_MS) {
      return;
    }
    asking = true;
    askedMs = nowMs;
    link.ask(Debugger::threads, this::answered, refused -> answered(List.of()));
  }

  private void answered(List<ThreadSnapshot> found) {
    asking = false;
    show(found);
  }

  private void show(List<ThreadSnapshot> found) {
    if (!found.equals(threads)) {
      threads = found;
      changed.run();
    }
  }
}
