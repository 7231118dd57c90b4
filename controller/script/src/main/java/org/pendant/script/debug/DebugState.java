package org.pendant.script.debug;

import java.util.List;
import java.util.Optional;
import org.pendant.script.vm.ThreadSnapshot;

/**
 * Debug state: whether a program is paused, and where its threads stand then.
 *
 * @param stop empty while nothing is paused
 * @param threads the main thread first; while nothing is paused only where calls are followed,
 *     otherwise empty
 */
public record DebugState(Optional<Stop> stop, List<ThreadSnapshot> threads) {
  /** Nothing is paused. */
  public static final DebugState FREE = new DebugState(Optional.empty(), List.of());

  public DebugState {
    threads = List.copyOf(threads);
  }

  /**
   * One stop.
   *
   * @param number counts the stops of a debugger, from 1
   * @param thread handle of the thread that caused it, 0 for the main thread
   * @param line 1-based line where that thread stands
   */
  public record Stop(long number, PauseReason reason, int thread, int line) {}

  /** Whether scripts and time are paused. */
  public boolean held() {
    return stop.isPresent();
  }
}
