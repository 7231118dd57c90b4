package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/**
 * Input action builtins: what high levels of inputs do by themselves (manual 19.3 to 19.5, 19.12,
 * 19.14).
 */
final class InputActionBuiltins {
  private static final String MODULE = "ioconfiguration";

  private InputActionBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    action(builtins, "set_configurable_digital_input_action", "19.3")
        .doc(
            "Lets a configurable digital input, 0 to 7, do nothing by itself (\"default\") or"
                + " switch freedrive on while it is high (\"freedrive\").")
        .does(call -> set(call, SignalBank.CONFIGURABLE_IN));
    action(builtins, "set_gp_boolean_input_action", "19.4")
        .doc(
            "Lets a boolean input register, 0 to 127, do nothing by itself (\"default\") or"
                + " switch freedrive on while it is True (\"freedrive\").")
        .does(InputActionBuiltins::setRegister);
    builtins
        .declare("set_input_actions_to_default")
        .manual(MODULE, "19.5")
        .doc("No digital input and no boolean input register does anything by itself any more.")
        .does(InputActionBuiltins::clear);
    action(builtins, "set_standard_digital_input_action", "19.12")
        .doc(
            "Lets a standard digital input, 0 to 7, do nothing by itself (\"default\") or"
                + " switch freedrive on while it is high (\"freedrive\").")
        .does(call -> set(call, SignalBank.STANDARD_IN));
    action(builtins, "set_tool_digital_input_action", "19.14")
        .doc(
            "Lets a digital input of the tool, 0 or 1, do nothing by itself (\"default\") or"
                + " switch freedrive on while it is high (\"freedrive\").")
        .does(call -> set(call, SignalBank.TOOL_IN));
  }

  private static Declaration<ControlBox> action(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(MODULE, section)
        .needs("port", Type.INT)
        .needs("action", Type.STRING);
  }

  private static Outcome set(Call<ControlBox> call, SignalBank bank) throws ScriptError {
    int port = call.integer(0, 0, bank.size() - 1);
    call.host().signals().setAction(new Signal(bank, port), action(call));
    return call.answer();
  }

  private static Outcome setRegister(Call<ControlBox> call) throws ScriptError {
    int port = call.integer(0, 0, RegisterKind.BOOLEAN.size() - 1);
    call.host().signals().setRegisterAction(port, action(call));
    return call.answer();
  }

  private static InputAction action(Call<ControlBox> call) throws ScriptError {
    return switch (call.word(1)) {
      case "default" -> InputAction.DEFAULT;
      case "freedrive" -> InputAction.FREEDRIVE;
      default -> throw call.refuse(1, text("defaultOrFreedrive"));
    };
  }

  private static Outcome clear(Call<ControlBox> call) {
    call.host().signals().clearActions();
    return call.answer();
  }
}
