package org.pendant.controller.function;

import org.pendant.controller.value.ScriptError;

/** The code of a built-in function. Never blocks, locks, does I/O or calls back into script. */
@FunctionalInterface
public interface BuiltinCode {
  Outcome run(Call call) throws ScriptError;
}
