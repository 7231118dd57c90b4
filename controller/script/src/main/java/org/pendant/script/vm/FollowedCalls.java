package org.pendant.script.vm;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * Followed calls: where the threads of a program stand, looked at after each frame. As long as none
 * has come to another instruction the list is the same object, and nothing is made.
 */
final class FollowedCalls {
  /**
   * With more calls than that nothing is said: a snapshot of them in each frame would take long.
   */
  private static final int MAX_CALLS = 64;

  private static final int WORDS_PER_THREAD = 3;

  private Optional<ProgramRun> run = Optional.empty();
  private int[] position = {};
  private List<ThreadSnapshot> threads = List.of();

  /** The threads of the program of {@code probe}; empty if it has too many calls. */
  List<ThreadSnapshot> of(ProgramRun now, ProgramProbe probe) {
    int[] at = position(now);
    if (run.filter(each -> each == now).isEmpty() || !Arrays.equals(at, position)) {
      run = Optional.of(now);
      position = at;
      List<ThreadSnapshot> found = at.length == 0 ? List.of() : probe.threads();
      threads = found.equals(threads) ? threads : List.copyOf(found);
    }
    return threads;
  }

  /** Empty for too many calls. */
  private static int[] position(ProgramRun run) {
    int words = 0;
    for (ScriptThread thread : run.threads()) {
      words += WORDS_PER_THREAD + thread.depth;
    }
    if (words > MAX_CALLS * (1 + WORDS_PER_THREAD)) {
      return new int[0];
    }
    int[] position = new int[words];
    int i = 0;
    for (ScriptThread thread : run.threads()) {
      position[i++] = thread.id();
      position[i++] = thread.state.hashCode();
      position[i++] = thread.depth;
      for (int call = 0; call < thread.depth; call++) {
        position[i++] = thread.reached(call);
      }
    }
    return position;
  }
}
