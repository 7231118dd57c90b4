package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.bench.Mock;
import org.pendant.controller.bench.MockedCall;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Mocks: functions that answer in place of others. A function of a program asks {@link #IS_MOCKED}
 * first of all, and answers with {@link #ANSWER} where that is so; builtins do so by themselves.
 */
public final class MockBuiltins {
  /** Whether a mock stands in for a function: takes its name. */
  public static final String IS_MOCKED = "$mocked";

  /** The answer of a mock: takes the name of the function and its arguments. */
  public static final String ANSWER = "$answer";

  /** The function of tests that replaces another one. */
  public static final String MOCK = "mock";

  /** The function of tests that replaces another one by one of the test. */
  public static final String MOCK_BY = "mock_by";

  /** Most parameters of a function of a program that can be replaced. */
  public static final int MAX_PARAMETERS = 16;

  private static final String SECTION = "Mocks";

  private MockBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, MOCK, SECTION)
        .doc(
            "Replaces a function, of a program or a built-in one, from now on: it does nothing and"
                + " answers this; of a list it answers one element after the other, and the last"
                + " one from then on.")
        .needs("function", Type.STRING)
        .takes("answer", Type.ANY, NoneValue.NONE)
        .does(
            call -> {
              TestBuiltins.bench(call).mocks().replace(call.text(0), call.value(1));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "mock_list", SECTION)
        .doc("As mock, of a function whose answer is always this list.")
        .needs("function", Type.STRING)
        .needs("answer", Type.ANY)
        .does(
            call -> {
              TestBuiltins.bench(call).mocks().replaceByOne(call.text(0), call.value(1));
              return call.answer();
            });
    TestBuiltins.declare(builtins, MOCK_BY, SECTION)
        .doc(
            "Replaces a function, of a program or a built-in one, by a function of the test file"
                + " from now on: that gets the arguments of each call, as many of them as it takes,"
                + " and what it returns is the answer, one frame later. Both names stand in"
                + " quotes.")
        .needs("function", Type.STRING)
        .needs("by", Type.STRING)
        .does(
            call -> {
              TestBuiltins.bench(call).mocks().replaceByFunction(call.text(0), call.text(1));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "unmock", SECTION)
        .doc("Has a function that was replaced do again what it does.")
        .needs("function", Type.STRING)
        .does(
            call -> {
              TestBuiltins.bench(call).mocks().restore(call.text(0));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "mock_calls", SECTION)
        .doc("How often a function was called that is replaced.")
        .needs("function", Type.STRING)
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt((int) Math.min(Integer.MAX_VALUE, mock(call).count())));
    TestBuiltins.declare(builtins, "mock_argument", SECTION)
        .doc("An argument that a replaced function was called with; both count from 0.")
        .needs("function", Type.STRING)
        .needs("call", Type.INT)
        .takes("argument", Type.INT, Value.of(0))
        .returns(Type.ANY)
        .effect(Effect.SENSES)
        .does(call -> call.answer(mock(call).argument(call.integer(1), call.integer(2))));
    declareParts(builtins);
  }

  private static void declareParts(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, IS_MOCKED, SECTION)
        .doc("Whether a function is replaced.")
        .needs("function", Type.STRING)
        .returns(Type.BOOL)
        .effect(Effect.ASKS)
        .does(call -> call.answer(TestBuiltins.bench(call).mocks().of(call.text(0)).isPresent()));
    Declaration<ControlBox> answer =
        TestBuiltins.declare(builtins, ANSWER, SECTION)
            .doc("The answer of what replaces a function.")
            .needs("function", Type.STRING)
            .needs("needed", Type.INT)
            .returns(Type.ANY);
    for (int i = 1; i <= MAX_PARAMETERS; i++) {
      answer.mayTake("a" + i, Type.ANY, Unit.NONE, "none");
    }
    answer.does(call -> answer(call, mock(call), call.integer(1), 2, MAX_PARAMETERS));
  }

  /**
   * Has a mock answer a call whose arguments for it are {@code count} from number {@code first}.
   *
   * @param needed how many of them each call has
   */
  static Outcome answer(Call<ControlBox> call, Mock mock, int needed, int first, int count)
      throws ScriptError {
    // what is run ahead of the arm must take no answer away
    call.program().foreseesSetting(false);
    List<Value> arguments = new ArrayList<>();
    for (int i = first; i < first + count && call.given(i); i++) {
      Value argument = call.value(i).copy();
      call.charge(argument.sizeBytes());
      arguments.add(argument);
    }
    if (mock.by().isEmpty()) {
      return call.answer(mock.answer(arguments));
    }
    if (!call.program().mayWait()) {
      throw call.failure("must-not-wait", text("mayNotWait", mock.by().get()));
    }
    return new Answer(TestBuiltins.bench(call).mocks().calls().ask(mock, needed, arguments));
  }

  /** Waits for the answer of a function of the test. */
  private record Answer(MockedCall asked) implements Wait {
    @Override
    public Optional<Value> poll(long frame) {
      return asked.over() ? Optional.of(asked.result()) : Optional.empty();
    }

    @Override
    public void cancel() {
      asked.cancel();
    }
  }

  private static Mock mock(Call<ControlBox> call) throws ScriptError {
    Optional<Mock> mock = TestBuiltins.bench(call).mocks().of(call.text(0));
    return mock.orElseThrow(() -> call.failure("not-mocked", text("notMocked")));
  }
}
