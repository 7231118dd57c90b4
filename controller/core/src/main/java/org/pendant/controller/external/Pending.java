package org.pendant.controller.external;

import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Pending result: something that was asked for and comes from outside. None of the methods waits.
 */
public interface Pending {
  /** Whether the result is there. */
  boolean over();

  /**
   * The result, once it is over; the caller owns it.
   *
   * @throws ScriptError when it has failed
   */
  Value result() throws ScriptError;

  /** Whether who answers lives in robot time, so that no clock has to wait for it. */
  default boolean inRobotTime() {
    return false;
  }

  /** The result is not wanted any more. */
  void cancel();
}
