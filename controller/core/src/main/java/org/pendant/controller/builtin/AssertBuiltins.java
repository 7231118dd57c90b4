package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Assertion builtins: a program's checks of itself (manual 7). */
final class AssertBuiltins {
  private AssertBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("assert")
        .manual("core", "7")
        .doc("Stops the program with an error unless the condition is True.")
        .needs("condition", Type.BOOL)
        .effect(Effect.COMPUTES)
        .does(AssertBuiltins::check);
  }

  private static Outcome check(Call<?> call) throws ScriptError {
    if (!call.bool(0)) {
      throw call.failure("assertion-failed", text("assertion"));
    }
    return call.answer();
  }
}
