package org.pendant.controller.builtin;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.ProgramControl;
import org.pendant.script.function.Work;
import org.pendant.script.value.LongOperation;
import org.pendant.script.value.Make;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.Registers;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Calls single functions and methods without a program around them. */
final class CallFixture {
  /** Functions that control a program are tested with the machine. */
  private static final ProgramControl NO_PROGRAM =
      new ProgramControl() {
        @Override
        public long frame() {
          throw new UnsupportedOperationException();
        }

        @Override
        public void pause() {
          throw new UnsupportedOperationException();
        }

        @Override
        public void halt() {
          throw new UnsupportedOperationException();
        }

        @Override
        public Outcome enterInterpreter(boolean clearQueueOnEnter, boolean clearOnEnd) {
          throw new UnsupportedOperationException();
        }

        @Override
        public void endInterpreter() {
          throw new UnsupportedOperationException();
        }

        @Override
        public void clearInterpreter() {
          throw new UnsupportedOperationException();
        }
      };

  static final Builtins<?> BUILTINS = StandardBuiltins.create();

  private final ControlBox box;

  /** A ur5e, exactly where it should be. */
  CallFixture() {
    this("ur5e");
  }

  CallFixture(String robotId) {
    box = new ControlBox(BoxSetup.headless(robotId));
  }

  /** The box that the functions work on. */
  ControlBox box() {
    return box;
  }

  /** The result of function {@code name}; arguments may be plain Java values. */
  Value call(String name, Object... arguments) throws ScriptError {
    return run(BUILTINS.find(name).orElseThrow(), 0, arguments);
  }

  /** The result of method {@code name} of the kind of values that {@code receiver} names. */
  Value method(Type receiver, String name, Object... selfAndArguments) throws ScriptError {
    return run(BUILTINS.findMethod(receiver, name).orElseThrow(), 1, selfAndArguments);
  }

  private Value run(Builtin<?> builtin, int receivers, Object... arguments) throws ScriptError {
    List<Optional<Value>> defaults = builtin.defaults();
    int result = receivers + defaults.size();
    Registers registers = new Registers(result + 1);
    for (int i = 0; i < result; i++) {
      if (i < arguments.length) {
        registers.set(i, Make.value(arguments[i]));
      } else if (defaults.get(i - receivers).isPresent()) {
        registers.set(i, defaults.get(i - receivers).get());
      }
    }
    Call<?> call = new Call<>(box, NO_PROGRAM, registers, new Work());
    Outcome outcome = call.run(builtin, 0, result);
    if (outcome instanceof Outcome.Begun begun) {
      outcome = call.resume(builtin, 0, result, LongOperation.finish(begun.operation()));
    }
    if (outcome != Outcome.Answered.ANSWERED) {
      throw new IllegalStateException(builtin.name() + " waits");
    }
    return registers.value(result);
  }

  static boolean nothing(Value value) {
    return value == NoneValue.NONE;
  }
}
