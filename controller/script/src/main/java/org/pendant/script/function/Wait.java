package org.pendant.script.function;

import java.util.List;
import java.util.Optional;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Wait: something a script thread waits for; the scheduler polls it once a frame, first in the
 * frame after the call. This is what takes physical time (manual 10.2).
 */
public non-sealed interface Wait extends Outcome {

  /**
   * The function's result once there is one (NONE for functions without), empty while waiting.
   *
   * @param frame number of the frame that is running
   * @throws ScriptError when the wait failed; the program stops with it
   */
  Optional<Value> poll(long frame) throws ScriptError;

  /**
   * Asks for an early end, as the interpreter's {@code abort} does for movej and movel (manual
   * 13.5).
   *
   * @return whether this wait can be ended early
   */
  default boolean abort() {
    return false;
  }

  /** Whether what the thread will do after this shapes what it waits for: a move that blends. */
  default boolean wantsLookAhead() {
    return false;
  }

  /** Answers {@link #wantsLookAhead}: what comes next, as far as can be foreseen. */
  default void lookAhead(List<Foreseen> next) {}

  /**
   * Whether it is for something outside, which lives by the wall clock: meanwhile robot time must
   * not go faster than that.
   */
  default boolean outside() {
    return false;
  }

  /** The thread was killed or the program stopped; the wait is polled no more. */
  default void cancel() {}
}
