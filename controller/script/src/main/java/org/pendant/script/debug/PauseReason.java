package org.pendant.script.debug;

import org.pendant.script.vm.ScriptFailure;

/** Pause reason: why a program is paused. */
public sealed interface PauseReason {

  /**
   * A breakpoint.
   *
   * @param line as it was set
   * @param hits how often this run came to it so far
   */
  record AtBreakpoint(int line, long hits) implements PauseReason {}

  /**
   * The condition of a breakpoint could not be computed.
   *
   * @param line of the breakpoint, as it was set
   */
  record ConditionFailed(int line, String message) implements PauseReason {}

  /** A step or a run to a line is over. */
  record Stepped() implements PauseReason {}

  /** A client asked for it. */
  record PauseRequested() implements PauseReason {}

  /** The program failed; it ends with this failure when it is let go. */
  record Failed(ScriptFailure failure) implements PauseReason {}
}
