package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.ToolSerialInterface;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.external.ToolSerialConnector;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Tool serial builtins: the serial line of the tool connector (manual 18.50). */
final class ToolSerialBuiltins {
  private ToolSerialBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("set_tool_communication")
        .manual("interfaces", "18.50")
        .doc(
            "Turns the serial line of the tool connector on or off. The baud rate is "
                + ToolCommunication.rates()
                + "; parity 0 none, 1 odd, 2 even; stop bits 1 or 2. Silence of rx_idle_chars"
                + " characters, 1 to 40, ends a message from the tool; one to it begins after"
                + " tx_idle_chars, 0 to 40. The tool's analog inputs are off while the line is on.")
        .needs("enabled", Type.BOOL)
        .needs("baud_rate", Type.INT)
        .needs("parity", Type.INT)
        .needs("stop_bits", Type.INT)
        .needs("rx_idle_chars", Type.NUMBER)
        .needs("tx_idle_chars", Type.NUMBER)
        .does(ToolSerialBuiltins::setUp);
  }

  private static Outcome setUp(Call<ControlBox> call) throws ScriptError {
    ToolCommunication wanted = wanted(call);
    ToolSerialInterface line = call.host().links().toolLine();
    ToolSerialConnector.SetUp setUp = line.setUp(wanted);
    if (setUp.over() || !call.program().mayWait()) {
      return call.answer();
    }
    return new ToolSerialWait(line, setUp, call.frame());
  }

  private static ToolCommunication wanted(Call<ControlBox> call) throws ScriptError {
    boolean enabled = call.bool(0);
    int baudRate = call.integer(1);
    if (!ToolCommunication.BAUD_RATES.contains(baudRate)) {
      throw call.refuse(1, text("oneOf", ToolCommunication.rates()));
    }
    return new ToolCommunication(
        enabled,
        baudRate,
        ToolCommunication.Parity.of(call.integer(2, 0, 2)),
        call.integer(3, 1, 2),
        idleChars(call, 4, ToolCommunication.MIN_RX_IDLE_CHARS),
        idleChars(call, 5, 0));
  }

  private static float idleChars(Call<ControlBox> call, int index, float least) throws ScriptError {
    double chars = call.number(index);
    if (!(chars >= least && chars <= ToolCommunication.MAX_IDLE_CHARS)) {
      throw call.refuse(index, text("range", (int) least, (int) ToolCommunication.MAX_IDLE_CHARS));
    }
    return (float) chars;
  }
}
