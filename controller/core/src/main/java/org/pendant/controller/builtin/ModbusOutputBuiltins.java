package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.modbus.ModbusSignal;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Modbus output builtins: setting Modbus signals, and sending requests to devices (manual 18.22 to
 * 18.25, 18.30, 19.1).
 */
final class ModbusOutputBuiltins {
  private static final int MAX_UNIT = 255;
  private static final int MAX_FUNCTION = 127;
  private static final int MAX_BYTE = 255;
  private static final int MAX_BYTES = 252;
  private static final int LAST_CHOICE = 5;

  private ModbusOutputBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareOutputs(builtins);
    declareActions(builtins);
    declareDevices(builtins);
  }

  private static void declareOutputs(Builtins<ControlBox> builtins) {
    builtins
        .declare("modbus_set_output_register")
        .manual(ModbusArguments.MODULE, "18.24")
        .doc(
            "Sets the registers of a Modbus signal, 0 to 65535 each: the first one, or as many as"
                + " the list has; the others keep their values.")
        .effect(Effect.TELLS)
        .needs(ModbusArguments.NAME, Type.STRING)
        .needs("register_value", Type.ANY)
        .takes("is_secondary_program", Type.BOOL, Value.of(false))
        .does(ModbusOutputBuiltins::setRegisters);
    builtins
        .declare("modbus_set_output_signal")
        .manual(ModbusArguments.MODULE, "18.25")
        .doc(
            "Sets the coils of a Modbus signal: the first one, or as many as the list has; the"
                + " others keep their values.")
        .effect(Effect.TELLS)
        .needs(ModbusArguments.NAME, Type.STRING)
        .needs("digital_value", Type.ANY)
        .takes("is_secondary_program", Type.BOOL, Value.of(false))
        .does(ModbusOutputBuiltins::setBits);
  }

  private static void declareActions(Builtins<ControlBox> builtins) {
    builtins
        .declare("modbus_set_digital_input_action")
        .manual(ModbusArguments.MODULE, "18.23")
        .doc(
            "Lets a digital Modbus input do nothing by itself (\"default\") or switch freedrive on"
                + " while it is high (\"freedrive\").")
        .needs(ModbusArguments.NAME, Type.STRING)
        .needs("action", Type.STRING)
        .does(ModbusOutputBuiltins::setAction);
    builtins
        .declare("modbus_set_runstate_dependent_choice")
        .manual("ioconfiguration", "19.1")
        .doc(
            "Keeps a Modbus output preserved (0), low (1) or high (2) while no program runs, high"
                + " only while one runs (3), low after an unexpected end (4), high from a start to"
                + " an unexpected end (5). High registers have all bits set.")
        .needs(ModbusArguments.NAME, Type.STRING)
        .needs("runstate_choice", Type.INT)
        .does(ModbusOutputBuiltins::chooseRunState);
  }

  private static void declareDevices(Builtins<ControlBox> builtins) {
    builtins
        .declare("modbus_send_custom_command")
        .manual(ModbusArguments.MODULE, "18.22")
        .doc(
            "Sends a request with any function code and data to a Modbus device, and waits until"
                + " the device has answered or had the time to. What it answers is not looked at;"
                + " fails when it cannot be reached.")
        .needs("IP", Type.STRING)
        .needs("slave_number", Type.INT)
        .needs("function_code", Type.INT)
        .needs("data", Type.LIST)
        .physicalTime()
        .does(ModbusOutputBuiltins::send);
    builtins
        .declare("modbus_reset_connection")
        .manual(ModbusArguments.MODULE, "18.30")
        .doc(
            "Closes the connection to a Modbus device and makes it again; waits until all its"
                + " signals have been answered, unless told not to.")
        .needs("connection_id", Type.STRING)
        .takes("is_blocking", Type.BOOL, Value.of(true))
        .does(ModbusOutputBuiltins::reset);
  }

  private static Outcome setRegisters(Call<ControlBox> call) throws ScriptError {
    ModbusArguments.refuseInternalFlag(call, 2);
    ModbusSignal signal = ModbusArguments.output(call, Optional.of(false));
    signal.set(ModbusArguments.registers(call, 1, signal.exchange().writeCount()));
    return call.answer();
  }

  private static Outcome setBits(Call<ControlBox> call) throws ScriptError {
    ModbusArguments.refuseInternalFlag(call, 2);
    ModbusSignal signal = ModbusArguments.output(call, Optional.of(true));
    signal.set(ModbusArguments.bits(call, 1, signal.exchange().writeCount()));
    return call.answer();
  }

  private static Outcome setAction(Call<ControlBox> call) throws ScriptError {
    ModbusSignal signal = ModbusArguments.signal(call);
    if (signal.exchange().kind() != ModbusKind.DIGITAL_INPUT) {
      throw call.failure(
          "wrong-signal",
          text(
              "wantsDigitalInput",
              SocketArguments.quoted(signal.name()),
              signal.exchange().kind().words()));
    }
    signal.setAction(
        switch (call.word(1)) {
          case "default" -> InputAction.DEFAULT;
          case "freedrive" -> InputAction.FREEDRIVE;
          default -> throw call.refuse(1, text("defaultOrFreedrive"));
        });
    return call.answer();
  }

  private static Outcome chooseRunState(Call<ControlBox> call) throws ScriptError {
    ModbusSignal signal = ModbusArguments.output(call, Optional.empty());
    RunStateAction action = RunStateAction.of(call.integer(1, 0, LAST_CHOICE));
    call.host()
        .links()
        .modbus()
        .chooseRunState(signal, action, call.host().signals().runState().now(action));
    return call.answer();
  }

  private static Outcome send(Call<ControlBox> call) throws ScriptError {
    call.program().reachesOutside();
    ModbusAddress device = ModbusArguments.address(call, 0);
    int unit = call.integer(1, 0, MAX_UNIT);
    int function = call.integer(2, 1, MAX_FUNCTION);
    byte[] data = bytes(call, 3);
    try {
      return new PendingWait(
          "modbus_send_custom_command",
          call.host().links().modbus().send(device, unit, function, data),
          result -> NoneValue.NONE);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
  }

  private static byte[] bytes(Call<ControlBox> call, int index) throws ScriptError {
    if (!(call.value(index) instanceof NumberList list)
        || (list.length() > 0 && list.elementKind() != ValueKind.INT)) {
      throw call.wrongKind(index, text("listOfInts"));
    }
    if (list.length() > MAX_BYTES) {
      throw call.refuse(index, text("mostElements", MAX_BYTES));
    }
    byte[] bytes = new byte[list.length()];
    for (int i = 0; i < bytes.length; i++) {
      double number = list.numberAt(i);
      if (number < 0 || number > MAX_BYTE) {
        throw call.refuse(index, text("intsTo", MAX_BYTE));
      }
      bytes[i] = (byte) number;
    }
    return bytes;
  }

  private static Outcome reset(Call<ControlBox> call) throws ScriptError {
    call.program().reachesOutside();
    ModbusAddress device = ModbusArguments.address(call, 0);
    boolean everyPort = !device.toString().equals(call.text(0));
    Optional<Integer> port = everyPort ? Optional.empty() : Optional.of(device.port());
    if (!call.host().links().modbus().reconnect(device.host(), port)) {
      throw call.failure(
          "unknown-device", text("unknownConnection", SocketArguments.quoted(call.text(0))));
    }
    return call.bool(1)
        ? new ModbusResetWait(call.host().links().modbus(), device.host(), port)
        : call.answer();
  }
}
