package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.Optional;
import org.pendant.controller.bench.MockedCall;
import org.pendant.controller.bench.MockedCalls;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Answering: what the made threads of a test call that have its functions answer calls of replaced
 * ones. One waits for calls and starts another for each; that takes the call, runs the function
 * with the arguments, and answers.
 */
public final class AnsweringBuiltins {
  /** Waits until there is a call. */
  public static final String AWAIT = "$await_call";

  /** The number of the oldest call, which is taken by that. */
  public static final String TAKE = "$take_call";

  /** Whether a call is for a function: takes the number, what was called, and the function. */
  public static final String IS_FOR = "$call_is_for";

  /**
   * With how many arguments the function is to be called: takes the number, and how many it takes
   * at least and at most.
   */
  public static final String COUNT = "$call_count";

  /** An argument of a call: takes the number, and which one. */
  public static final String ARGUMENT = "$call_argument";

  /** Answers a call: takes the number and the answer. */
  public static final String ANSWER = "$call_answer";

  private static final String SECTION = "Mocks";

  private AnsweringBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, AWAIT, SECTION)
        .doc("Waits until a function of the test has to answer.")
        .physicalTime()
        .does(
            call -> {
              MockedCalls calls = calls(call);
              Wait wait = _ -> calls.announce() ? Optional.of(NoneValue.NONE) : Optional.empty();
              return calls.announce() ? call.answer() : wait;
            });
    TestBuiltins.declare(builtins, TAKE, SECTION)
        .doc("Takes the oldest call.")
        .returns(Type.INT)
        .does(call -> call.answerInt(calls(call).take()));
    TestBuiltins.declare(builtins, IS_FOR, SECTION)
        .doc("Whether a function of the test is to answer a call.")
        .needs("call", Type.INT)
        .needs("function", Type.STRING)
        .needs("by", Type.STRING)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(
            call -> {
              Optional<MockedCall> asked = calls(call).taken(call.integer(0));
              return call.answer(
                  asked.isPresent()
                      && asked.get().mock().function().equals(call.text(1))
                      && asked.get().mock().by().orElse("").equals(call.text(2)));
            });
    TestBuiltins.declare(builtins, COUNT, SECTION)
        .doc("How many arguments the function of the test gets.")
        .needs("call", Type.INT)
        .needs("least", Type.INT)
        .needs("most", Type.INT)
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt(count(asked(call), call.integer(1), call.integer(2))));
    TestBuiltins.declare(builtins, ARGUMENT, SECTION)
        .doc("An argument of a call.")
        .needs("call", Type.INT)
        .needs("argument", Type.INT)
        .returns(Type.ANY)
        .effect(Effect.SENSES)
        .does(call -> call.answer(asked(call).arguments().get(call.integer(1)).copy()));
    TestBuiltins.declare(builtins, ANSWER, SECTION)
        .doc("Answers a call.")
        .needs("call", Type.INT)
        .mayTake("answer", Type.ANY, Unit.NONE, "none")
        .does(
            call -> {
              Value answer = call.given(1) ? call.value(1).copy() : NoneValue.NONE;
              calls(call).answer(call.integer(0), answer);
              return call.answer();
            });
  }

  private static int count(MockedCall asked, int least, int most) throws ScriptError {
    int given = asked.arguments().size();
    if (given < least || asked.needed() > most) {
      throw new ScriptError(
          "wrong-arguments",
          text(
              "calledWith",
              mismatch(asked.mock().by().orElse(""), least, most),
              asked.mock().function(),
              given));
    }
    return Math.min(given, most);
  }

  /** How many arguments a function takes that cannot answer for another one. */
  public static String mismatch(String by, int least, int most) {
    if (least == most) {
      return text(most == 1 ? "takesOne" : "takes", by, most);
    }
    return text(most == 1 ? "takesUpToOne" : "takesRange", by, least, most);
  }

  private static MockedCalls calls(Call<ControlBox> call) {
    return TestBuiltins.bench(call).mocks().calls();
  }

  private static MockedCall asked(Call<ControlBox> call) throws ScriptError {
    return calls(call)
        .taken(call.integer(0))
        .orElseThrow(() -> call.failure("no-such-call", text("hasAnswer")));
  }
}
