package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** The methods of structs (manual 4.3.2). */
final class StructMethods {
  private StructMethods() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declareMethod(Type.STRUCT, "length")
        .manual("core", "4.3.2")
        .doc("The number of members.")
        .returns(Type.INT)
        .effect(Effect.COMPUTES)
        .does(call -> call.answerInt(call.struct(0).length()));
    builtins
        .declareMethod(Type.STRUCT, "to_string")
        .manual("core", "4.3.2")
        .doc("The struct as text, shortened with ...} beyond 1023 characters.")
        .returns(Type.STRING)
        .effect(Effect.COMPUTES)
        .does(StringBuiltins::toStringMethod);
  }
}
