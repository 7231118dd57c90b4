package org.pendant.controller.machine;

/**
 * Who is asked whether the program is to be held, and told of its life. All calls come from the
 * frame loop, in the middle of a frame.
 */
public interface Sentry {
  /** Lets everything pass. */
  Sentry NONE = new Sentry() {};

  /**
   * Thread {@code thread} stands before a statement that has a trap.
   *
   * @return whether everything is held here
   */
  default boolean stopsAt(int thread) {
    return false;
  }

  /**
   * Thread {@code thread} failed, which ends the program.
   *
   * @return whether everything is held before that
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
