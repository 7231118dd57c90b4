package org.pendant.script.function;

import org.pendant.script.value.ScriptError;

/** Method code: one for all methods of a kind of value whose names are known outside only. */
@FunctionalInterface
public interface AnyMethodCode<H extends Host> {
  /**
   * Runs a method.
   *
   * @param method its name
   * @param count how many arguments there are after the receiver
   */
  Outcome run(Call<H> call, String method, int count) throws ScriptError;
}
