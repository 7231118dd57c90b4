package org.pendant.script.debug;

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
}
