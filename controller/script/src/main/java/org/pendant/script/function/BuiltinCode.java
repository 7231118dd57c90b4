package org.pendant.script.function;

import org.pendant.script.value.ScriptError;

/** Code of a built-in function. Never blocks, locks, does I/O or calls back into script. */
@FunctionalInterface
public interface BuiltinCode<H extends Host> {
  Outcome run(Call<H> call) throws ScriptError;
}
