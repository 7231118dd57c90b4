package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;

/** Interpreter mode as programs see it (manual 13). */
final class InterpreterBuiltins {
  private static final String MODULE = "interpreter";

  private InterpreterBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("interpreter_mode")
        .manual(MODULE, "13.2")
        .doc("Executes statements that arrive from outside until the mode is ended.")
        .takes("clearQueueOnEnter", Type.BOOL, Value.of(true))
        .takes("clearOnEnd", Type.BOOL, Value.of(true))
        .physicalTime()
        .does(call -> call.program().enterInterpreter(call.bool(0), call.bool(1)));
    builtins
        .declare("end_interpreter")
        .manual(MODULE, "13.3")
        .doc("Ends interpreter mode: interpreter_mode returns.")
        .does(
            call -> {
              call.program().endInterpreter();
              return call.answer();
            });
    builtins
        .declare("clear_interpreter")
        .manual(MODULE, "13.4")
        .doc("Forgets the statements that were interpreted so far.")
        .does(
            call -> {
              call.program().clearInterpreter();
              return call.answer();
            });
  }
}
