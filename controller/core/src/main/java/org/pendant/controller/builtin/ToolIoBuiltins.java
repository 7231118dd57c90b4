package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/**
 * Tool connector builtins: how the connector at the tool flange is set up (manual 18.51 to 18.53).
 */
final class ToolIoBuiltins {
  private static final String MODULE = "interfaces";

  private ToolIoBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("set_tool_digital_output_mode")
        .manual(MODULE, "18.51")
        .doc(
            "Lets a digital output of the tool, 0 or 1, sink current (1, NPN), source it (2, PNP)"
                + " or both (3, push-pull).")
        .needs("n", Type.INT)
        .needs("mode", Type.INT)
        .alias("Mode")
        .does(ToolIoBuiltins::setPin);
    builtins
        .declare("set_tool_output_mode")
        .manual(MODULE, "18.52")
        .doc("Uses the tool's two output pins as digital outputs (0) or as a power supply (1).")
        .needs("mode", Type.INT)
        .alias("Mode")
        .does(ToolIoBuiltins::setMode);
    builtins
        .declare("set_tool_voltage")
        .manual(MODULE, "18.53")
        .doc("Sets what the tool connector supplies: 0, 12 or 24 V.")
        .needs("voltage", Type.INT)
        .does(ToolIoBuiltins::setVoltage);
  }

  private static Outcome setPin(Call<ControlBox> call) throws ScriptError {
    int n = call.integer(0, 0, 1);
    ToolPinMode mode = ToolPinMode.of(call.integer(1, 1, ToolPinMode.values().length));
    return write(call, new SignalWrite.ToolPin(n, mode));
  }

  private static Outcome setMode(Call<ControlBox> call) throws ScriptError {
    return write(
        call,
        new SignalWrite.ToolOutputs(
            call.integer(0, 0, 1) == 0 ? ToolOutputMode.DIGITAL : ToolOutputMode.DUAL_PIN_POWER));
  }

  private static Outcome setVoltage(Call<ControlBox> call) throws ScriptError {
    int volts = call.integer(0);
    if (!ToolConnector.isVoltage(volts)) {
      throw call.refuse(0, text("voltages"));
    }
    return write(call, new SignalWrite.ToolVoltage(volts));
  }

  private static Outcome write(Call<ControlBox> call, SignalWrite write) {
    call.host().signals().write(write);
    return call.answer();
  }
}
