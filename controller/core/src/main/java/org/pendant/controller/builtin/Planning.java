package org.pendant.controller.builtin;

import org.pendant.motion.MotionFailure;
import org.pendant.motion.PlanningException;
import org.pendant.script.function.Call;
import org.pendant.script.value.ScriptError;

/** Planning failures as script errors: the only place where the first become the second. */
final class Planning {

  /** Something that plans, or has the arm do what was planned. */
  interface Step<T> {
    T run() throws PlanningException, ScriptError;
  }

  /** Something that the arm is told. */
  interface Action {
    void run() throws PlanningException, ScriptError;
  }

  private Planning() {}

  /** Does something; its errors carry the name of the called function. */
  static void act(Call<?> call, Action action) throws ScriptError {
    named(
        call,
        () -> {
          action.run();
          return call;
        });
  }

  /** Does something; its errors carry the name of the called function. */
  static <T> T named(Call<?> call, Step<T> step) throws ScriptError {
    try {
      return step.run();
    } catch (PlanningException e) {
      throw failure(call, e);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  /** The failure with the name of the called function, for calls that happen in each frame. */
  static ScriptError failure(Call<?> call, PlanningException why) {
    return call.failure(why.code(), why.getMessage());
  }

  /**
   * The failure of a motion that a thread waits for.
   *
   * @param function that began the motion
   */
  static ScriptError failure(String function, MotionFailure why) {
    return new ScriptError(why.code(), function + ": " + why.message());
  }
}
