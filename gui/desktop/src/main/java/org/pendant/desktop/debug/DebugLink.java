package org.pendant.desktop.debug;

import java.util.function.Consumer;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.ScriptError;

/** Debugger link: leads to the debugger in the frame loop. */
public interface DebugLink {

  /**
   * Something to ask; it runs in the frame loop.
   *
   * @param <T> what it finds out
   */
  @FunctionalInterface
  interface Request<T> {
    /**
     * Asks it.
     *
     * @throws IllegalArgumentException if it cannot be done now
     * @throws ScriptError if an expression fails
     */
    T of(Debugger debugger) throws ScriptError;
  }

  /**
   * Asks the debugger in one of the next frames; {@code answer} or {@code refusal} is told on the
   * dispatch thread.
   */
  <T> void ask(Request<T> request, Consumer<T> answer, Consumer<String> refusal);

  /** Resumes a program that is paused, but not by the debugger; {@code refusal} as above. */
  void resume(Consumer<String> refusal);
}
