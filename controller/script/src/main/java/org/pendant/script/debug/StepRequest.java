package org.pendant.script.debug;

import java.util.Optional;
import java.util.Set;
import org.pendant.script.vm.StackMark;

/** Step request: for how far a paused thread may run. */
sealed interface StepRequest {
  /** The thread that steps. */
  int thread();

  /** To its next statement, wherever that is. */
  record Into(int thread) implements StepRequest {}

  /** To the next statement of a call that it is in now. */
  record Over(int thread, StackMark calls) implements StepRequest {}

  /** To the next statement of a call around the innermost one. */
  record Out(int thread, StackMark calls) implements StepRequest {}

  /**
   * To one statement.
   *
   * @param start its first offset in the program's text
   */
  record To(int thread, int start) implements StepRequest {}

  /**
   * To one of some statements, by whatever thread comes to one first.
   *
   * @param starts their first offsets in the program's text
   * @param past the calls whose next statement ends the step as well; empty for none
   */
  record ToAny(int thread, Set<Integer> starts, Optional<StackMark> past) implements StepRequest {
    public ToAny {
      starts = Set.copyOf(starts);
    }
  }

  /** What is left of the step when a thread has ended. */
  default Optional<StepRequest> without(int ended) {
    if (ended != thread()) {
      return Optional.of(this);
    }
    return this instanceof ToAny any
        ? Optional.of(new ToAny(any.thread(), any.starts(), Optional.empty()))
        : Optional.empty();
  }
}
