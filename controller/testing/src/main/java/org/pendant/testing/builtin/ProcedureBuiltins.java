package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.Optional;
import org.pendant.controller.bench.Mock;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Remote procedures: the XML-RPC server that programs reach, played by the test in robot time. */
public final class ProcedureBuiltins {
  /** The function of tests that has one of the test answer a remote procedure. */
  public static final String RPC_ANSWER_BY = "rpc_answer_by";

  private static final String SECTION = "Remote procedures";

  private ProcedureBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "rpc_answer", SECTION)
        .doc(
            "Has the test be the server that rpc_factory reaches, at whatever address, and answer"
                + " this to a procedure; of a list it answers one element after the other, and the"
                + " last one from then on.")
        .needs("procedure", Type.STRING)
        .takes("answer", Type.ANY, NoneValue.NONE)
        .does(
            call -> {
              TestBuiltins.bench(call).rpc().answer(call.text(0), call.value(1));
              return call.answer();
            });
    TestBuiltins.declare(builtins, RPC_ANSWER_BY, SECTION)
        .doc(
            "As rpc_answer, with a function of the test file, named in quotes: that gets the"
                + " arguments of each call, as many of them as it takes, and what it returns is the"
                + " answer.")
        .needs("procedure", Type.STRING)
        .needs("by", Type.STRING)
        .does(
            call -> {
              TestBuiltins.bench(call).rpc().answerBy(call.text(0), call.text(1));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "rpc_calls", SECTION)
        .doc("How often programs have called a procedure of the test.")
        .needs("procedure", Type.STRING)
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt((int) Math.min(Integer.MAX_VALUE, procedure(call).count())));
    TestBuiltins.declare(builtins, "rpc_argument", SECTION)
        .doc("An argument that a procedure of the test was called with; both count from 0.")
        .needs("procedure", Type.STRING)
        .needs("call", Type.INT)
        .takes("argument", Type.INT, Value.of(0))
        .returns(Type.ANY)
        .effect(Effect.SENSES)
        .does(call -> call.answer(procedure(call).argument(call.integer(1), call.integer(2))));
  }

  private static Mock procedure(Call<ControlBox> call) throws ScriptError {
    Optional<Mock> mock = TestBuiltins.bench(call).rpc().procedure(call.text(0));
    return mock.orElseThrow(() -> call.failure("not-mocked", text("noRpcAnswer")));
  }
}
