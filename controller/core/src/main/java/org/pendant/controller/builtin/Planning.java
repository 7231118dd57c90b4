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
      throw call.failure(e.failure().code(), e.failure().message());
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  /** Does something; its errors begin with {@code name}. */
  static <T> T named(String name, Step<T> step) throws ScriptError {
    try {
      return step.run();
    } catch (PlanningException e) {
      throw new ScriptError(e.failure().code(), name + e.failure().message());
    } catch (ScriptError e) {
      throw new ScriptError(e.code(), name + e.getMessage());
    }
  }

  /** The failure of a motion that was under way. */
  static ScriptError error(MotionFailure failure) {
    return new ScriptError(failure.code(), failure.message());
  }
}
