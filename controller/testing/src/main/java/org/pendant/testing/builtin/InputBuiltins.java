package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.bench.IoChanges;
import org.pendant.controller.bench.OutputFollower;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Inputs of the box as the cell around the arm sets them. */
final class InputBuiltins {
  private static final String SECTION = "The world under test";
  private static final String NO_SIGNAL = "value-out-of-range";

  private InputBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    digital(builtins, "set_standard_digital_in", SignalBank.STANDARD_IN, "a standard");
    digital(builtins, "set_configurable_digital_in", SignalBank.CONFIGURABLE_IN, "a configurable");
    digital(builtins, "set_tool_digital_in", SignalBank.TOOL_IN, "a tool's");
    analog(builtins, "set_standard_analog_in", AnalogBank.STANDARD_IN);
    analog(builtins, "set_tool_analog_in", AnalogBank.TOOL_IN);
    TestBuiltins.declare(builtins, "write_input_boolean_register", SECTION)
        .doc("Writes a boolean input register, 0 to 127, as a client would.")
        .needs("address", Type.INT)
        .needs("value", Type.BOOL)
        .does(
            call ->
                write(
                    call,
                    address ->
                        new SignalWrite.BooleanRegister(
                            RegisterDirection.INPUT, address, call.bool(1))));
    TestBuiltins.declare(builtins, "write_input_integer_register", SECTION)
        .doc("Writes an integer input register, 0 to 47, as a client would.")
        .needs("address", Type.INT)
        .needs("value", Type.INT)
        .does(
            call ->
                write(
                    call,
                    address ->
                        new SignalWrite.IntegerRegister(
                            RegisterDirection.INPUT, address, call.integer(1))));
    TestBuiltins.declare(builtins, "write_input_float_register", SECTION)
        .doc("Writes a float input register, 0 to 47, as a client would.")
        .needs("address", Type.INT)
        .needs("value", Type.NUMBER)
        .does(
            call ->
                write(
                    call,
                    address ->
                        new SignalWrite.FloatRegister(
                            RegisterDirection.INPUT, address, call.number(1))));
    TestBuiltins.declare(builtins, "set_speed_slider", SECTION)
        .doc("Moves the speed slider, 0 to 1, from the next frame on.")
        .needs("fraction", Type.NUMBER)
        .does(InputBuiltins::speed);
    declareFollower(builtins);
    TestBuiltins.declare(builtins, "assert_io_order", SECTION)
        .doc(
            "Fails the test unless these changes of digital signals came about in this order since"
                + " its start, others between them or not: [\"DO0 on\", \"DI5 on\", \"DO0 off\"]."
                + " DI and DO are standard inputs and outputs, CI and CO configurable ones, TI and"
                + " TO the tool's.")
        .needs("changes", Type.LIST)
        .does(InputBuiltins::order);
  }

  private static void digital(
      Builtins<ControlBox> builtins, String name, SignalBank bank, String which) {
    TestBuiltins.declare(builtins, name, SECTION)
        .doc("Sets the level of " + which + " digital input, as what is connected there does.")
        .needs("n", Type.INT)
        .needs("level", Type.BOOL)
        .does(call -> write(call, n -> new SignalWrite.Digital(new Signal(bank, n), call.bool(1))));
  }

  private static void analog(Builtins<ControlBox> builtins, String name, AnalogBank bank) {
    TestBuiltins.declare(builtins, name, SECTION)
        .doc(
            "Sets an analog input to a voltage of 0 to 10 V, or with domain 0 to a current of 0.004"
                + " to 0.02 A.")
        .needs("n", Type.INT)
        .needs("value", Type.NUMBER)
        .takes("domain", Type.INT, Value.of(1))
        .does(
            call -> {
              AnalogDomain domain = AnalogDomain.of(call.integer(2, 0, 1));
              return write(call, n -> new SignalWrite.AnalogInput(bank, n, call.number(1), domain));
            });
  }

  private static void declareFollower(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "wire", SECTION)
        .doc(
            "Has a standard digital input follow a standard digital output a while later, as the"
                + " switch of a gripper follows its valve.")
        .needs("output", Type.INT)
        .needs("input", Type.INT)
        .takes("delay", Unit.SECOND, 0)
        .takes("inverted", Type.BOOL, Value.of(false))
        .does(InputBuiltins::wire);
  }

  /** Makes a change of the first argument, the number of a signal. */
  private interface Change {
    SignalWrite of(int number) throws ScriptError;
  }

  private static Outcome write(Call<ControlBox> call, Change change) throws ScriptError {
    int number = call.integer(0);
    try {
      call.host().signals().write(change.of(number));
    } catch (IllegalArgumentException e) {
      throw call.failure(NO_SIGNAL, e.getMessage());
    }
    return call.answer();
  }

  private static Outcome order(Call<ControlBox> call) throws ScriptError {
    ListValue list = call.list(0);
    List<String> wanted = new ArrayList<>();
    for (int i = 0; i < list.length(); i++) {
      wanted.add(list.get(i).text());
    }
    IoChanges changes = TestBuiltins.bench(call).changes();
    int found = changes.inOrder(wanted);
    if (found < wanted.size()) {
      throw call.failure(
          AssertionCodes.FAILED,
          found == 0
              ? text("didNotCome", wanted.getFirst(), changes.told())
              : text("didNotComeAfter", wanted.get(found - 1), wanted.get(found), changes.told()));
    }
    return call.answer();
  }

  private static Outcome speed(Call<ControlBox> call) throws ScriptError {
    double fraction = call.number(0);
    if (!(fraction >= 0 && fraction <= 1)) {
      throw call.refuse(0, text("zeroToOne"));
    }
    TestBuiltins.bench(call).post(new BoxCommand.SetSpeedFraction(fraction));
    return call.answer();
  }

  private static Outcome wire(Call<ControlBox> call) throws ScriptError {
    double delay = call.number(2);
    if (!(delay >= 0)) {
      throw call.refuse(2, text("notNegative"));
    }
    TestBuiltins.bench(call)
        .followers()
        .add(
            new OutputFollower(
                new Signal(SignalBank.STANDARD_OUT, call.integer(0, 0, 7)),
                new Signal(SignalBank.STANDARD_IN, call.integer(1, 0, 7)),
                FrameTime.framesFor(delay),
                call.bool(3)));
    return call.answer();
  }
}
