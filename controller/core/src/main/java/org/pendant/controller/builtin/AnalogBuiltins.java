package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/**
 * Analog signals (manual 18.3, 18.4, 18.11, 18.12, 18.15, 18.42, 18.43, 18.47, 19.2, 19.11, 19.13).
 */
final class AnalogBuiltins {
  private static final String INTERFACES = "interfaces";
  private static final String CONFIGURATION = "ioconfiguration";
  private static final int LAST = AnalogBank.SIZE - 1;

  /** The last number of the old functions, which count the tool's inputs on from the box's. */
  private static final int LAST_OLD = 2 * AnalogBank.SIZE - 1;

  private AnalogBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareReading(builtins);
    declareWriting(builtins);
    declareDomains(builtins);
    declareDeprecated(builtins);
  }

  private static void declareReading(Builtins<ControlBox> builtins) {
    read(builtins, "get_standard_analog_in", "18.11")
        .doc("What a standard analog input, 0 or 1, reads: A or V, as its domain is.")
        .does(call -> get(call, AnalogBank.STANDARD_IN));
    read(builtins, "get_standard_analog_out", "18.12")
        .doc("What a standard analog output, 0 or 1, puts out: A or V, as its domain is.")
        .does(call -> get(call, AnalogBank.STANDARD_OUT));
    read(builtins, "get_tool_analog_in", "18.15")
        .doc("What an analog input of the tool, 0 or 1, reads: A or V, as its domain is.")
        .does(call -> get(call, AnalogBank.TOOL_IN));
  }

  private static void declareWriting(Builtins<ControlBox> builtins) {
    builtins
        .declare("set_standard_analog_out")
        .manual(INTERFACES, "18.47")
        .doc(
            "Sets a standard analog output, 0 or 1, to a part of its range:"
                + " 0 is 4 mA or 0 V, 1 is 20 mA or 10 V.")
        .needs("n", Type.INT)
        .needs("f", Type.NUMBER)
        .effect(Effect.TELLS)
        .does(AnalogBuiltins::setOutput);
  }

  private static void declareDomains(Builtins<ControlBox> builtins) {
    domain(builtins, "set_analog_outputdomain", "19.2")
        .doc("Makes a standard analog output, 0 or 1, a current (0) or a voltage (1).")
        .does(call -> setDomain(call, AnalogBank.STANDARD_OUT));
    domain(builtins, "set_standard_analog_input_domain", "19.11")
        .doc("Lets a standard analog input, 0 or 1, read a current (0) or a voltage (1).")
        .does(call -> setDomain(call, AnalogBank.STANDARD_IN));
    domain(builtins, "set_tool_analog_input_domain", "19.13")
        .doc("Lets an analog input of the tool, 0 or 1, read a current (0) or a voltage (1).")
        .does(call -> setDomain(call, AnalogBank.TOOL_IN));
  }

  private static void declareDeprecated(Builtins<ControlBox> builtins) {
    read(builtins, "get_analog_in", "18.3")
        .doc("What an analog input reads: 0 and 1 are standard ones, 2 and 3 the tool's.")
        .deprecated("get_standard_analog_in")
        .does(AnalogBuiltins::getOld);
    read(builtins, "get_analog_out", "18.4")
        .doc("What a standard analog output, 0 or 1, puts out: A or V, as its domain is.")
        .deprecated("get_standard_analog_out")
        .does(call -> get(call, AnalogBank.STANDARD_OUT));
    builtins
        .declare("set_analog_inputrange")
        .manual(INTERFACES, "18.42")
        .doc(
            "Chooses what an analog input reads. Ports 0 and 1 are standard ones, 2 and 3 the"
                + " tool's. A standard port takes range 0 or 2 (0 to 10 V), one of the tool 0 or 1"
                + " (0 to 10 V) or 2 (4 to 20 mA).")
        .needs("port", Type.INT)
        .needs("range", Type.INT)
        .deprecated("set_standard_analog_input_domain")
        .does(AnalogBuiltins::setOldRange);
    builtins
        .declare("set_analog_out")
        .manual(INTERFACES, "18.43")
        .doc("Sets a standard analog output, 0 or 1, to a part of its range, 0 to 1.")
        .needs("n", Type.INT)
        .needs("f", Type.NUMBER)
        .deprecated("set_standard_analog_out")
        .does(AnalogBuiltins::setOutput);
  }

  private static Declaration<ControlBox> read(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(INTERFACES, section)
        .needs("n", Type.INT)
        .returns(Type.NUMBER)
        .effect(Effect.ASKS);
  }

  private static Declaration<ControlBox> domain(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(CONFIGURATION, section)
        .needs("port", Type.INT)
        .needs("domain", Type.INT);
  }

  private static Outcome get(Call<ControlBox> call, AnalogBank bank) throws ScriptError {
    return call.answer(call.host().signals().analog().value(bank, call.integer(0, 0, LAST)));
  }

  private static Outcome getOld(Call<ControlBox> call) throws ScriptError {
    int n = call.integer(0, 0, LAST_OLD);
    return call.answer(call.host().signals().analog().value(oldBank(n), n % AnalogBank.SIZE));
  }

  private static AnalogBank oldBank(int n) {
    return n < AnalogBank.SIZE ? AnalogBank.STANDARD_IN : AnalogBank.TOOL_IN;
  }

  private static Outcome setOutput(Call<ControlBox> call) throws ScriptError {
    int n = call.integer(0, 0, LAST);
    double ratio = call.number(1);
    if (!(ratio >= 0 && ratio <= 1)) {
      throw call.refuse(1, text("zeroToOne"));
    }
    call.host().signals().analog().setOutput(n, ratio);
    return call.answer();
  }

  private static Outcome setDomain(Call<ControlBox> call, AnalogBank bank) throws ScriptError {
    int port = call.integer(0, 0, LAST);
    AnalogDomain domain = AnalogDomain.of(call.integer(1, 0, 1));
    call.host().signals().analog().setDomain(bank, port, domain);
    return call.answer();
  }

  private static Outcome setOldRange(Call<ControlBox> call) throws ScriptError {
    int port = call.integer(0, 0, LAST_OLD);
    AnalogBank bank = oldBank(port);
    int range = call.integer(1);
    AnalogDomain domain =
        switch (bank) {
          case STANDARD_IN, STANDARD_OUT -> standardRange(call, range);
          case TOOL_IN -> toolRange(call, range);
        };
    call.host().signals().analog().setDomain(bank, port % AnalogBank.SIZE, domain);
    return call.answer();
  }

  private static AnalogDomain standardRange(Call<ControlBox> call, int range) throws ScriptError {
    if (range != 0 && range != 2) {
      throw call.refuse(1, text("boxRange"));
    }
    return AnalogDomain.VOLTAGE;
  }

  private static AnalogDomain toolRange(Call<ControlBox> call, int range) throws ScriptError {
    if (range < 0 || range > 2) {
      throw call.refuse(1, text("toolRange"));
    }
    return range == 2 ? AnalogDomain.CURRENT : AnalogDomain.VOLTAGE;
  }
}
