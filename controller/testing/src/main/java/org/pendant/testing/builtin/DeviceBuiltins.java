package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.bench.ModbusDevice;
import org.pendant.controller.bench.ModbusDevice.Table;
import org.pendant.controller.bench.ModbusDevices;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Devices: the Modbus devices that programs have signals at, played by the test in robot time. */
final class DeviceBuiltins {
  private static final String SECTION = "Modbus devices";
  private static final int MAX_ADDRESS = 65_535;
  private static final int MAX_REGISTER = 65_535;
  private static final int MAX_EXCEPTION = 255;

  private DeviceBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    named(builtins, "modbus_device")
        .doc(
            "Has the test be the Modbus device at an address, written as in modbus_add_signal:"
                + " \"192.168.1.30\", or \"plc:1502\" for another port than 502. All its coils,"
                + " inputs and registers are there, 0 at first, for every slave number.")
        .does(
            call -> {
              TestBuiltins.bench(call).devices().play(address(call));
              return call.answer();
            });
    declareValues(builtins);
    declareRequests(builtins);
    declareFaults(builtins);
  }

  private static void declareValues(Builtins<ControlBox> builtins) {
    setting(builtins, "device_set_input", Table.INPUTS, "digital inputs");
    setting(builtins, "device_set_coil", Table.COILS, "coils, which are digital outputs,");
    setting(builtins, "device_set_input_register", Table.INPUT_REGISTERS, "input registers");
    setting(builtins, "device_set_register", Table.REGISTERS, "registers");
    named(builtins, "device_coil")
        .doc("What a coil of a device is, as a program or the test has set it.")
        .needs("n", Type.INT)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(value(call, Table.COILS) != 0));
    named(builtins, "device_register")
        .doc("What a register of a device is, as a program or the test has set it.")
        .needs("n", Type.INT)
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt(value(call, Table.REGISTERS)));
  }

  private static void declareRequests(Builtins<ControlBox> builtins) {
    named(builtins, "device_requests")
        .doc("How many requests programs and signals have sent to a device.")
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt((int) Math.min(Integer.MAX_VALUE, device(call).requests())));
    named(builtins, "device_commands")
        .doc("How many requests have come by modbus_send_custom_command.")
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt(device(call).commands().size()));
    named(builtins, "device_command")
        .doc(
            "The bytes of a request that has come by modbus_send_custom_command, counted from 0:"
                + " slave number, function code, and the data.")
        .needs("n", Type.INT)
        .returns(Type.LIST)
        .effect(Effect.SENSES)
        .does(
            call -> {
              List<List<Integer>> all = device(call).commands();
              if (all.isEmpty()) {
                throw call.failure("no-such-call", text("noRequest"));
              }
              List<Integer> bytes = all.get(call.integer(1, 0, all.size() - 1));
              double[] numbers = bytes.stream().mapToDouble(Integer::doubleValue).toArray();
              return call.answer(NumberList.owning(numbers, numbers.length, ValueKind.INT));
            });
  }

  private static void declareFaults(Builtins<ControlBox> builtins) {
    named(builtins, "device_delay")
        .doc("Has a device answer this much later; after 1 s its answers count as missing.")
        .needs("delay", Unit.SECOND)
        .does(
            call -> {
              double delay = call.number(1);
              if (!(delay >= 0)) {
                throw call.refuse(1, text("notNegative"));
              }
              device(call).setDelayFrames(FrameTime.framesFor(delay));
              return call.answer();
            });
    named(builtins, "device_error")
        .doc(
            "Has a device answer every request with an exception code, such as 2 for an address"
                + " that it does not have; with 0 it does what it is asked again.")
        .needs("code", Type.INT)
        .does(
            call -> {
              device(call).setException(call.integer(1, 0, MAX_EXCEPTION));
              return call.answer();
            });
    named(builtins, "device_silent")
        .doc("Has a device answer nothing, or everything again.")
        .takes("silent", Type.BOOL, Value.of(true))
        .does(
            call -> {
              device(call).setSilent(call.bool(1));
              return call.answer();
            });
    named(builtins, "device_refuse")
        .doc("Has a device refuse connections and end those that there are, or accept them again.")
        .takes("refuse", Type.BOOL, Value.of(true))
        .does(
            call -> {
              device(call).setRefuses(call.bool(1));
              return call.answer();
            });
  }

  private static Declaration<ControlBox> named(Builtins<ControlBox> builtins, String name) {
    return TestBuiltins.declare(builtins, name, SECTION).needs("address", Type.STRING);
  }

  private static void setting(
      Builtins<ControlBox> builtins, String name, Table table, String what) {
    named(builtins, name)
        .doc(
            "Sets "
                + what
                + " of a device: the one of this number, or with a list those from it on.")
        .needs("n", Type.INT)
        .needs("value", Type.ANY)
        .does(call -> set(call, table));
  }

  private static Outcome set(Call<ControlBox> call, Table table) throws ScriptError {
    boolean bits = table == Table.COILS || table == Table.INPUTS;
    List<Integer> values = bits ? bits(call) : registers(call);
    int first = call.integer(1, 0, MAX_ADDRESS);
    if (first + values.size() - 1 > MAX_ADDRESS) {
      throw call.refuse(1, text("noRoom", values.size(), MAX_ADDRESS));
    }
    device(call).set(table, first, values);
    return call.answer();
  }

  private static List<Integer> bits(Call<ControlBox> call) throws ScriptError {
    if (call.kind(2) != ValueKind.LIST) {
      return List.of(call.bool(2) ? 1 : 0);
    }
    if (!(call.value(2) instanceof NumberList list)) {
      throw call.wrongKind(2, text("boolOrBools"));
    }
    List<Integer> values = new ArrayList<>();
    for (int i = 0; i < list.length(); i++) {
      values.add(list.numberAt(i) != 0 ? 1 : 0);
    }
    return values;
  }

  private static List<Integer> registers(Call<ControlBox> call) throws ScriptError {
    if (call.kind(2) != ValueKind.LIST) {
      return List.of(call.integer(2, 0, MAX_REGISTER));
    }
    List<Integer> values = new ArrayList<>();
    for (double number : call.numbers(2, -1)) {
      if (number != (int) number || number < 0 || number > MAX_REGISTER) {
        throw call.refuse(2, text("intsTo", MAX_REGISTER));
      }
      values.add((int) number);
    }
    return values;
  }

  private static int value(Call<ControlBox> call, Table table) throws ScriptError {
    return device(call).value(table, call.integer(1, 0, MAX_ADDRESS));
  }

  private static ModbusAddress address(Call<ControlBox> call) throws ScriptError {
    try {
      return ModbusAddress.parse(call.text(0));
    } catch (IllegalArgumentException e) {
      throw call.refuse(0, e.getMessage());
    }
  }

  private static ModbusDevice device(Call<ControlBox> call) throws ScriptError {
    ModbusAddress address = address(call);
    return TestBuiltins.bench(call)
        .devices()
        .at(address)
        .orElseThrow(() -> call.failure("no-device", ModbusDevices.hint(address)));
  }
}
