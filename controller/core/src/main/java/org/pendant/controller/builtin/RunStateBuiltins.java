package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Outputs that follow what the program does (manual 19.6 to 19.10). */
final class RunStateBuiltins {
  private static final String MODULE = "ioconfiguration";
  private static final String CHOICES =
      " preserved (0), low (1) or high (2) while no program runs, high only while one runs (3),"
          + " low after an unexpected end (4), high from a start to an unexpected end (5)";
  private static final String POWER =
      CHOICES + ", high (6) or low (7) only while the arm has power.";
  private static final int LAST = RunStateAction.values().length - 1;
  private static final int LAST_WITHOUT_POWER = 5;

  private RunStateBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    choose(builtins, "set_runstate_configurable_digital_output_to_value", "19.6")
        .doc("Keeps a configurable digital output, 0 to 7," + POWER)
        .does(call -> choose(call, SignalBank.CONFIGURABLE_OUT, LAST));
    choose(builtins, "set_runstate_gp_boolean_output_to_value", "19.7")
        .doc("Keeps a boolean output register, 0 to 127," + POWER)
        .does(RunStateBuiltins::chooseRegister);
    choose(builtins, "set_runstate_standard_analog_output_to_value", "19.8")
        .doc("Keeps a standard analog output, 0 or 1, at an end of its range:" + POWER)
        .does(RunStateBuiltins::chooseAnalog);
    choose(builtins, "set_runstate_standard_digital_output_to_value", "19.9")
        .doc("Keeps a standard digital output, 0 to 7," + POWER)
        .does(call -> choose(call, SignalBank.STANDARD_OUT, LAST));
    choose(builtins, "set_runstate_tool_digital_output_to_value", "19.10")
        .doc("Keeps a digital output of the tool, 0 or 1," + CHOICES + ".")
        .does(call -> choose(call, SignalBank.TOOL_OUT, LAST_WITHOUT_POWER));
    declareOld(builtins, "set_runstate_configurable_digital_outputs");
    declareOld(builtins, "set_runstate_outputs");
    declareOld(builtins, "set_runstate_standard_digital_outputs");
  }

  private static Declaration<ControlBox> choose(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(MODULE, section)
        .needs("outputId", Type.INT)
        .needs("state", Type.INT);
  }

  /** In programs that older robot software wrote; the manual does not have them. */
  private static void declareOld(Builtins<ControlBox> builtins, String name) {
    builtins
        .declare(name)
        .manual(MODULE, "19")
        .doc("Accepts a list of outputs in old programs, and changes nothing.")
        .needs("outputs", Type.LIST)
        .deprecated("set_runstate_standard_digital_output_to_value")
        .does(RunStateBuiltins::accept);
  }

  private static Outcome choose(Call<ControlBox> call, SignalBank bank, int last)
      throws ScriptError {
    int output = call.integer(0, 0, bank.size() - 1);
    call.host().signals().runState().choose(new Signal(bank, output), action(call, last));
    return call.answer();
  }

  private static Outcome chooseRegister(Call<ControlBox> call) throws ScriptError {
    int output = call.integer(0, 0, RegisterKind.BOOLEAN.size() - 1);
    call.host().signals().runState().chooseRegister(output, action(call, LAST));
    return call.answer();
  }

  private static Outcome chooseAnalog(Call<ControlBox> call) throws ScriptError {
    int output = call.integer(0, 0, AnalogBank.SIZE - 1);
    call.host().signals().runState().chooseAnalog(output, action(call, LAST));
    return call.answer();
  }

  private static RunStateAction action(Call<ControlBox> call, int last) throws ScriptError {
    return RunStateAction.of(call.integer(1, 0, last));
  }

  private static Outcome accept(Call<ControlBox> call) throws ScriptError {
    call.list(0);
    return call.answer();
  }
}
