package org.pendant.testing.builtin;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.bench.Mock;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.signature.Parameter;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.BuiltinCode;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;

/** Catalogue of what tests may call: everything that programs may, and the test builtins. */
public final class TestBuiltins {
  /** The module of all of them, where the manual's stands for other builtins. */
  public static final String MODULE = "testing";

  private TestBuiltins() {}

  /** A new catalogue. */
  public static Builtins<ControlBox> create() {
    Builtins<ControlBox> builtins = StandardBuiltins.create();
    AssertionBuiltins.declareIn(builtins);
    NearBuiltins.declareIn(builtins);
    ExpectationBuiltins.declareIn(builtins);
    ProgramBuiltins.declareIn(builtins);
    InputBuiltins.declareIn(builtins);
    StopBuiltins.declareIn(builtins);
    OperatorTestBuiltins.declareIn(builtins);
    MockBuiltins.declareIn(builtins);
    AnsweringBuiltins.declareIn(builtins);
    PeerBuiltins.declareIn(builtins);
    ProcedureBuiltins.declareIn(builtins);
    DeviceBuiltins.declareIn(builtins);
    CellBuiltins.declareIn(builtins);
    GeneratorBuiltins.declareIn(builtins);
    return builtins;
  }

  /** Whether only what is made of tests calls the function, and no text of people. */
  public static boolean isHidden(String function) {
    return function.startsWith("$") || function.equals(ExpectationBuiltins.TEST_NUMBER);
  }

  /** A declaration of a test builtin. */
  static Declaration<ControlBox> declare(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins.declare(name).manual(MODULE, section);
  }

  /** The bench of the test that calls. */
  static TestBench bench(Call<ControlBox> call) {
    return call.host()
        .environment()
        .testBench()
        .orElseThrow(() -> new IllegalStateException("a test builtin runs outside of tests"));
  }

  /**
   * A catalogue in which functions ask the bench first whether a {@link Mock} stands in for them.
   *
   * @param names of the functions; those of no builtin are left aside
   */
  public static Builtins<ControlBox> mockable(Builtins<ControlBox> builtins, Set<String> names) {
    Map<String, BuiltinCode<ControlBox>> replaced = new HashMap<>();
    for (String name : names) {
      builtins.find(name).ifPresent(builtin -> replaced.put(name, mockable(builtin)));
    }
    return replaced.isEmpty() ? builtins : builtins.replacing(replaced);
  }

  private static BuiltinCode<ControlBox> mockable(Builtin<ControlBox> builtin) {
    BuiltinCode<ControlBox> own = builtin.code();
    int parameters = builtin.signature().parameters().size();
    int needed =
        (int) builtin.signature().parameters().stream().filter(Parameter::required).count();
    String name = builtin.name();
    return call -> {
      Optional<Mock> mock = bench(call).mocks().of(name);
      return mock.isEmpty()
          ? own.run(call)
          : MockBuiltins.answer(call, mock.get(), needed, 0, parameters);
    };
  }
}
