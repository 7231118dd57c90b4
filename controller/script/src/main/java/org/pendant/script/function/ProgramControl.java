package org.pendant.script.function;

import org.pendant.script.value.ScriptError;

/** Program control: what a built-in function may do to the program that calls it. */
public interface ProgramControl {

  /**
   * Frames that the program has been running; stands still while it is paused. {@link Wait#poll}
   * counts the same.
   */
  long frame();

  /**
   * Tells what the program is about to begin, which takes time.
   *
   * @return whether that is all that is wanted, and nothing is to begin
   * @throws ScriptError when enough is known
   */
  default boolean foresees(Foreseen next) throws ScriptError {
    return false;
  }

  /**
   * Tells that something is about to be set that what follows may depend on.
   *
   * @param unchanged whether it is that already
   * @return whether that is all that is wanted, and nothing is to be set
   * @throws ScriptError when enough is known
   */
  default boolean foreseesSetting(boolean unchanged) throws ScriptError {
    return false;
  }

  /**
   * Tells that something is about to be sent to the outside, or asked for there.
   *
   * @throws ScriptError when this must not be
   */
  default void reachesOutside() throws ScriptError {}

  /** Whether the program may wait, which must end within its frame where it may not. */
  default boolean mayWait() {
    return true;
  }

  /** Pauses the program as the pause button does; script time stands still until resumed. */
  void pause();

  /** Ends the program after this instruction, as {@code halt} does. */
  void halt();

  /**
   * Puts the calling thread into interpreter mode (manual 13.2); the answer comes when it ends.
   *
   * @param clearQueueOnEnter whether statements received so far are dropped
   * @param clearOnEnd whether interpreted statements go away when the mode ends
   * @throws ScriptError outside the main thread, or when already in interpreter mode
   */
  Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd) throws ScriptError;

  /** Ends interpreter mode (manual 13.3). */
  void endInterpreter();

  /**
   * Clears what was interpreted so far (manual 13.4).
   *
   * @throws ScriptError when no interpreter mode is active
   */
  void clearInterpreter() throws ScriptError;
}
