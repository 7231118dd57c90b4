package org.pendant.controller.function;

import org.pendant.controller.value.ScriptError;

/** The code of all methods of a kind of value whose names only somebody outside knows. */
@FunctionalInterface
public interface AnyMethodCode {
  /**
   * Runs a method.
   *
   * @param method its name
   * @param count how many arguments there are behind the receiver
   */
  Outcome run(Call call, String method, int count) throws ScriptError;
}
