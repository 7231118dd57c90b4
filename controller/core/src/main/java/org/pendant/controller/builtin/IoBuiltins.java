package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.SignalBank;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Digital signals and flags (manual 18.5 to 18.9, 18.13 to 18.17, 18.44 to 18.49). */
final class IoBuiltins {
  private static final String MODULE = "interfaces";

  private IoBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareReading(builtins);
    declareWriting(builtins);
    declareDeprecated(builtins);
  }

  private static void declareReading(Builtins<ControlBox> builtins) {
    read(builtins, "get_configurable_digital_in", "18.5")
        .doc("The level of a configurable digital input, 0 to 7.")
        .does(call -> get(call, SignalBank.CONFIGURABLE_IN));
    read(builtins, "get_configurable_digital_out", "18.6")
        .doc("The level of a configurable digital output, 0 to 7.")
        .does(call -> get(call, SignalBank.CONFIGURABLE_OUT));
    read(builtins, "get_flag", "18.9")
        .doc("An internal flag, 0 to 31; flags outlive the program.")
        .does(call -> get(call, SignalBank.FLAG));
    read(builtins, "get_standard_digital_in", "18.13")
        .doc("The level of a standard digital input, 0 to 7.")
        .does(call -> get(call, SignalBank.STANDARD_IN));
    read(builtins, "get_standard_digital_out", "18.14")
        .doc("The level of a standard digital output, 0 to 7.")
        .does(call -> get(call, SignalBank.STANDARD_OUT));
    read(builtins, "get_tool_digital_in", "18.16")
        .doc("The level of a digital input of the tool, 0 or 1.")
        .does(call -> get(call, SignalBank.TOOL_IN));
    read(builtins, "get_tool_digital_out", "18.17")
        .doc("The level of a digital output of the tool, 0 or 1.")
        .does(call -> get(call, SignalBank.TOOL_OUT));
  }

  private static void declareWriting(Builtins<ControlBox> builtins) {
    write(builtins, "set_configurable_digital_out", "18.44")
        .doc("Sets a configurable digital output, 0 to 7.")
        .does(call -> set(call, SignalBank.CONFIGURABLE_OUT));
    write(builtins, "set_flag", "18.46")
        .doc("Sets an internal flag, 0 to 31; flags outlive the program.")
        .does(call -> set(call, SignalBank.FLAG));
    write(builtins, "set_standard_digital_out", "18.48")
        .doc("Sets a standard digital output, 0 to 7.")
        .does(call -> set(call, SignalBank.STANDARD_OUT));
    write(builtins, "set_tool_digital_out", "18.49")
        .doc("Sets a digital output of the tool, 0 or 1.")
        .does(call -> set(call, SignalBank.TOOL_OUT));
  }

  private static void declareDeprecated(Builtins<ControlBox> builtins) {
    read(builtins, "get_digital_in", "18.7")
        .doc("The level of a digital input: 0 to 7 are standard ones, 8 and 9 the tool's.")
        .deprecated("get_standard_digital_in")
        .does(call -> getOld(call, SignalBank.STANDARD_IN, SignalBank.TOOL_IN));
    read(builtins, "get_digital_out", "18.8")
        .doc("The level of a digital output: 0 to 7 are standard ones, 8 and 9 the tool's.")
        .deprecated("get_standard_digital_out")
        .does(call -> getOld(call, SignalBank.STANDARD_OUT, SignalBank.TOOL_OUT));
    write(builtins, "set_digital_out", "18.45")
        .doc("Sets a digital output: 0 to 7 are standard ones, 8 and 9 the tool's.")
        .deprecated("set_standard_digital_out")
        .does(IoBuiltins::setOld);
  }

  private static Declaration<ControlBox> read(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(MODULE, section)
        .needs("n", Type.INT)
        .returns(Type.BOOL)
        .effect(Effect.ASKS);
  }

  private static Declaration<ControlBox> write(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(MODULE, section)
        .needs("n", Type.INT)
        .needs("b", Type.BOOL)
        .effect(Effect.TELLS);
  }

  private static Outcome get(Call<ControlBox> call, SignalBank bank) throws ScriptError {
    return call.answer(
        call.host().signals().digital().level(bank, call.integer(0, 0, bank.size() - 1)));
  }

  private static Outcome set(Call<ControlBox> call, SignalBank bank) throws ScriptError {
    call.host().signals().digital().set(bank, call.integer(0, 0, bank.size() - 1), call.bool(1));
    return call.answer();
  }

  private static Outcome getOld(Call<ControlBox> call, SignalBank standard, SignalBank tool)
      throws ScriptError {
    int n = call.integer(0, 0, standard.size() + tool.size() - 1);
    boolean onTool = n >= standard.size();
    return call.answer(
        onTool
            ? call.host().signals().digital().level(tool, n - standard.size())
            : call.host().signals().digital().level(standard, n));
  }

  private static Outcome setOld(Call<ControlBox> call) throws ScriptError {
    int standard = SignalBank.STANDARD_OUT.size();
    int n = call.integer(0, 0, standard + SignalBank.TOOL_OUT.size() - 1);
    if (n >= standard) {
      call.host().signals().digital().set(SignalBank.TOOL_OUT, n - standard, call.bool(1));
    } else {
      call.host().signals().digital().set(SignalBank.STANDARD_OUT, n, call.bool(1));
    }
    return call.answer();
  }
}
