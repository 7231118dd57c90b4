package org.pendant.controller.builtin;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.controller.external.Pending;
import org.pendant.script.function.Wait;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Wait of a script thread for an answer from outside. */
final class PendingWait implements Wait {
  private final String function;
  private final Pending pending;
  private final UnaryOperator<Value> answer;

  /**
   * Waits for {@code pending}.
   *
   * @param function what was called, for messages
   * @param answer makes the function's result of what came
   */
  PendingWait(String function, Pending pending, UnaryOperator<Value> answer) {
    this.function = function;
    this.pending = pending;
    this.answer = answer;
  }

  @Override
  public Optional<Value> poll(long frame) throws ScriptError {
    if (!pending.over()) {
      return Optional.empty();
    }
    try {
      return Optional.of(answer.apply(pending.result()));
    } catch (ScriptError e) {
      throw new ScriptError(e.code(), function + ": " + e.getMessage());
    }
  }

  @Override
  public boolean outside() {
    return !pending.inRobotTime();
  }

  @Override
  public void cancel() {
    pending.cancel();
  }
}
