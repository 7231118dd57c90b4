package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.io.PortMap;
import org.pendant.controller.io.SignalWrite;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Bits and registers that Modbus clients see as well (manual 18.38, 18.39, 18.70, 18.71). */
final class PortBuiltins {
  private static final String MODULE = "interfaces";

  /** The manual's upper limit, one beyond what 16 bits hold; it counts as 0. */
  private static final int HIGHEST = 0x10000;

  private PortBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("read_port_bit")
        .manual(MODULE, "18.38")
        .doc(
            "A bit that Modbus clients see as well: 0 to 47 are signals, 128 to 255 memory, 260 to"
                + " 265 the robot's state.")
        .needs("address", Type.INT)
        .returns(Type.BOOL)
        .effect(Effect.ASKS)
        .does(PortBuiltins::readBit);
    builtins
        .declare("read_port_register")
        .manual(MODULE, "18.39")
        .doc(
            "A register that Modbus clients see as well, -32768 to 32767: 0 to 33 are signals, 128"
                + " to 255 memory, 256 to 770 the robot's state at the end of the frame before.")
        .needs("address", Type.INT)
        .returns(Type.INT)
        .effect(Effect.ASKS)
        .does(PortBuiltins::readRegister);
    builtins
        .declare("write_port_bit")
        .manual(MODULE, "18.70")
        .doc(
            "Writes a bit that Modbus clients see as well; a bit of an input stays as it is,"
                + " with a warning.")
        .needs("address", Type.INT)
        .needs("value", Type.BOOL)
        .effect(Effect.TELLS)
        .does(PortBuiltins::writeBit);
    builtins
        .declare("write_port_register")
        .manual(MODULE, "18.71")
        .doc(
            "Writes a register that Modbus clients see as well, -32768 to 65536; one of an input"
                + " stays as it is, with a warning.")
        .needs("address", Type.INT)
        .needs("value", Type.INT)
        .effect(Effect.TELLS)
        .does(PortBuiltins::writeRegister);
  }

  private static Outcome readBit(Call<ControlBox> call) throws ScriptError {
    int address = call.integer(0);
    ControlBox box = call.host();
    return call.answer(
        PortMap.bit(address, box.signals().digital().levels(), box.signals().state())
            .or(() -> box.links().published().portBit(address))
            .orElseThrow(() -> call.refuse(0, text("portBits")))
            .booleanValue());
  }

  private static Outcome readRegister(Call<ControlBox> call) throws ScriptError {
    int address = call.integer(0);
    ControlBox box = call.host();
    int value =
        PortMap.register(address, box.signals().digital().levels(), box.signals().state())
            .or(() -> box.links().published().portRegister(address))
            .orElseThrow(() -> call.refuse(0, text("portRegisters")));
    return call.answerInt((short) value);
  }

  private static Outcome writeBit(Call<ControlBox> call) throws ScriptError {
    int address = call.integer(0);
    return write(
        call,
        "bitIsInput",
        address,
        PortMap.writeBit(address, call.bool(1))
            .or(() -> call.host().links().published().portBit(address).map(ofRobot -> List.of()))
            .orElseThrow(() -> call.refuse(0, text("portBits"))));
  }

  private static Outcome writeRegister(Call<ControlBox> call) throws ScriptError {
    int address = call.integer(0);
    int value = call.integer(1, Short.MIN_VALUE, HIGHEST) & 0xFFFF;
    try {
      return write(
          call,
          "registerIsInput",
          address,
          PortMap.writeRegister(address, value)
              .or(
                  () ->
                      call.host()
                          .links()
                          .published()
                          .portRegister(address)
                          .map(ofRobot -> List.of()))
              .orElseThrow(() -> call.refuse(0, text("portRegisters"))));
    } catch (IllegalArgumentException e) {
      throw call.failure("value-out-of-range", e.getMessage());
    }
  }

  private static Outcome write(
      Call<ControlBox> call, String warning, int address, List<SignalWrite> writes) {
    if (writes.isEmpty()) {
      call.host().log().warnOnce(text(warning, address));
    }
    writes.forEach(call.host().signals()::write);
    return call.answer();
  }
}
