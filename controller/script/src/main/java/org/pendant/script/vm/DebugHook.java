package org.pendant.script.vm;

/**
 * Debug hook: decides where the program pauses for a debugger, and hears of starts and ends. All
 * calls come from the frame loop, in the middle of a frame.
 */
public interface DebugHook {
  /** Lets everything pass. */
  DebugHook NONE = new DebugHook() {};

  /**
   * Thread {@code thread} stands before a statement that has a trap.
   *
   * @return whether everything is paused here
   */
  default boolean stopsAt(int thread) {
    return false;
  }

  /**
   * Thread {@code thread} failed, which ends the program.
   *
   * @return whether everything is paused before that
   */
  default boolean stopsAtFailure(int thread, ScriptFailure failure) {
    return false;
  }

  /** A program was started; none of it has run. */
  default void programStarted() {}

  /** The program ended; its threads are gone. */
  default void programEnded() {}

  /** A thread other than the main one ended. */
  default void threadEnded(int thread) {}
}
