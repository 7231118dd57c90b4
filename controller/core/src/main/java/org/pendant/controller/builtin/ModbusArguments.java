package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.modbus.ModbusSignal;
import org.pendant.script.function.Call;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Modbus arguments: what the functions of Modbus signals share. */
final class ModbusArguments {
  static final String MODULE = "interfaces";

  /** The text of most first parameters. */
  static final String NAME = "signal_name";

  private static final int MAX_NAME = 20;
  private static final int MAX_REGISTER = 65_535;

  private ModbusArguments() {}

  /** The address of a device. */
  static ModbusAddress address(Call<ControlBox> call, int index) throws ScriptError {
    try {
      return ModbusAddress.parse(call.text(index));
    } catch (IllegalArgumentException e) {
      throw call.refuse(index, e.getMessage());
    }
  }

  /** A name for a new signal. */
  static String newName(Call<ControlBox> call, int index) throws ScriptError {
    String name = call.text(index);
    if (name.isEmpty() || name.length() > MAX_NAME) {
      throw call.refuse(index, text("characters", MAX_NAME));
    }
    return name;
  }

  /** The signal that argument 0 names. */
  static ModbusSignal signal(Call<ControlBox> call) throws ScriptError {
    try {
      return call.host().links().modbus().signal(call.text(0));
    } catch (ScriptError e) {
      throw e.code().equals("unknown-signal") ? call.failure(e.code(), e.getMessage()) : e;
    }
  }

  /** The output that argument 0 names; of bits or of registers, where only one of them will do. */
  static ModbusSignal output(Call<ControlBox> call, Optional<Boolean> digital) throws ScriptError {
    ModbusSignal signal = signal(call);
    ModbusKind kind = signal.exchange().kind();
    if (!kind.output() || digital.orElse(kind.digital()) != kind.digital()) {
      String refusal =
          digital
              .map(bits -> bits ? "wantsDigitalOutput" : "wantsRegisterOutput")
              .orElse("wantsOutput");
      throw call.failure(
          "wrong-signal", text(refusal, SocketArguments.quoted(signal.name()), kind.words()));
    }
    return signal;
  }

  /** The flag of programs that the manual keeps for the controller itself. */
  static void refuseInternalFlag(Call<ControlBox> call, int index) throws ScriptError {
    if (call.bool(index)) {
      throw call.refuse(index, text("mustBeFalse"));
    }
  }

  /** One register or a list of them for an output that has {@code most}. */
  static List<Integer> registers(Call<ControlBox> call, int index, int most) throws ScriptError {
    if (call.kind(index) != ValueKind.LIST) {
      return List.of(call.integer(index, 0, MAX_REGISTER));
    }
    List<Integer> values = new ArrayList<>();
    for (double number : numbers(call, index, most)) {
      if (number != (int) number || number < 0 || number > MAX_REGISTER) {
        throw call.refuse(index, text("intsTo", MAX_REGISTER));
      }
      values.add((int) number);
    }
    return values;
  }

  /** One bit or a list of them for an output that has {@code most}. */
  static List<Integer> bits(Call<ControlBox> call, int index, int most) throws ScriptError {
    if (call.kind(index) != ValueKind.LIST) {
      return List.of(call.bool(index) ? 1 : 0);
    }
    if (!(call.value(index) instanceof NumberList list)
        || (list.length() > 0 && list.elementKind() != ValueKind.BOOL)) {
      throw call.wrongKind(index, text("boolOrBools"));
    }
    List<Integer> values = new ArrayList<>();
    for (int i = 0; i < list.length(); i++) {
      values.add(list.numberAt(i) != 0 ? 1 : 0);
    }
    refuseLength(call, index, values.size(), most);
    return values;
  }

  private static double[] numbers(Call<ControlBox> call, int index, int most) throws ScriptError {
    if (!(call.value(index) instanceof NumberList list)
        || (list.length() > 0 && !list.elementKind().isNumber())) {
      throw call.wrongKind(index, text("intOrInts"));
    }
    refuseLength(call, index, list.length(), most);
    return call.numbers(index, -1);
  }

  private static void refuseLength(Call<ControlBox> call, int index, int length, int most)
      throws ScriptError {
    if (length < 1 || length > most) {
      throw call.refuse(index, text("elements", most));
    }
  }
}
