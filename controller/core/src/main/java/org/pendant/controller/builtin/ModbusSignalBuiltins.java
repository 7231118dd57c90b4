package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ModbusReading;
import org.pendant.controller.modbus.ModbusSignal;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/**
 * Modbus signal builtins: adding and reading signals (manual 18.18 to 18.21, 18.26 to 18.29,
 * 18.31).
 */
final class ModbusSignalBuiltins {
  private static final int MAX_UNIT = 255;
  private static final int MAX_ADDRESS = 65_535;

  /** Registers that fit a request which reads as well (Modbus V1.1b3, 6.17). */
  private static final int MAX_WRITTEN = 121;

  private static final int MAX_HZ = 500;
  private static final int MAX_WATCHDOG_S = 300;

  private ModbusSignalBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareAdding(builtins);
    declareReading(builtins);
    declareWatching(builtins);
  }

  private static void declareAdding(Builtins<ControlBox> builtins) {
    builtins
        .declare("modbus_add_signal")
        .manual(ModbusArguments.MODULE, "18.18")
        .doc(
            "Begins to read or write a coil, input or register of a Modbus device, 10 times a"
                + " second. Types are digital input (0) and output (1), register input (2) and"
                + " output (3), and several digital (15) or register (16) outputs. A name that is"
                + " taken gets the new signal, which stays when the program ends.")
        .needs("IP", Type.STRING)
        .needs("slave_number", Type.INT)
        .needs("signal_address", Type.INT)
        .needs("signal_type", Type.INT)
        .needs("signal_name", Type.STRING)
        .takes("sequential_mode", Type.BOOL, Value.of(false))
        .takes("register_count", Type.INT, Value.of(1))
        .does(ModbusSignalBuiltins::add);
    builtins
        .declare("modbus_add_rw_signal")
        .manual(ModbusArguments.MODULE, "18.19")
        .doc(
            "Begins to read registers of a Modbus device, 10 times a second, and to write others"
                + " in the same request once modbus_set_output_register has said what.")
        .needs("IP", Type.STRING)
        .needs("slave_number", Type.INT)
        .needs("read_address", Type.INT)
        .needs("read_register_count", Type.INT)
        .needs("write_address", Type.INT)
        .needs("write_register_count", Type.INT)
        .needs("signal_name", Type.STRING)
        .takes("sequential_mode", Type.BOOL, Value.of(false))
        .does(ModbusSignalBuiltins::addReadWrite);
    named(builtins, "modbus_delete_signal", "18.20")
        .doc("Ends a Modbus signal.")
        .does(ModbusSignalBuiltins::delete);
  }

  private static void declareReading(Builtins<ControlBox> builtins) {
    named(builtins, "modbus_get_signal_status", "18.21")
        .doc(
            "The value of a Modbus signal: a bool or an int, or a list of them when it has several"
                + " coils or registers. An output has the value that it was set to. Fails when the"
                + " signal has not been valid for longer than its watchdog allows.")
        .takes("is_secondary_program", Type.BOOL, Value.of(false))
        .returns(Type.ANY)
        .effect(Effect.ASKS)
        .does(ModbusSignalBuiltins::status);
    named(builtins, "modbus_request_update_signal_value", "18.29")
        .doc("Has a Modbus signal read or written once more, as soon as possible.")
        .does(ModbusSignalBuiltins::update);
    named(builtins, "modbus_set_signal_update_frequency", "18.26")
        .doc(
            "Changes how often a Modbus signal is read or written, 0 to 500 Hz. With 0 or -1 that"
                + " happens on demand only: when it is read, set, or asked to be updated.")
        .needs("update_frequency", Type.INT)
        .does(ModbusSignalBuiltins::setFrequency);
  }

  private static void declareWatching(Builtins<ControlBox> builtins) {
    named(builtins, "modbus_get_error", "18.27")
        .doc(
            "What is wrong with a Modbus signal, 0 for nothing: the error of the connection in the"
                + " upper 16 bits and that of the device in the lower ones (error_source 0), or one"
                + " of them, of the device (1) or the connection (2).")
        .takes("error_source", Type.INT, Value.of(0))
        .returns(Type.INT)
        .effect(Effect.ASKS)
        .does(ModbusSignalBuiltins::error);
    named(builtins, "modbus_get_time_since_signal_invalid", "18.28")
        .doc(
            "For how many seconds a Modbus signal has not been read or written successfully; 0 when"
                + " nothing is wrong with it.")
        .returns(Type.NUMBER)
        .effect(Effect.ASKS)
        .does(
            call ->
                call.answer(ModbusArguments.signal(call).invalidS(call.host().clock().timeS())));
    named(builtins, "modbus_set_signal_watchdog", "18.31")
        .doc(
            "Changes how long a Modbus signal may be without a valid answer before reading it"
                + " fails, 0 to 300 s; 2 s unless said.")
        .needs("new_timeout_in_sec", Type.NUMBER)
        .does(ModbusSignalBuiltins::setWatchdog);
  }

  private static Declaration<ControlBox> named(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(ModbusArguments.MODULE, section)
        .needs(ModbusArguments.NAME, Type.STRING);
  }

  private static Outcome add(Call<ControlBox> call) throws ScriptError {
    int number = call.integer(3);
    Optional<ModbusKind> kind =
        ModbusKind.of(number).filter(each -> each != ModbusKind.READ_WRITE_REGISTERS);
    if (kind.isEmpty()) {
      throw call.refuse(3, text("functionCode"));
    }
    int count = call.integer(6, 1, ModbusExchange.MOST);
    int address = address(call, 2, count);
    return add(
        call,
        ModbusArguments.newName(call, 4),
        new ModbusExchange(
            ModbusArguments.address(call, 0),
            call.integer(1, 0, MAX_UNIT),
            kind.get(),
            address,
            count,
            address,
            count,
            call.bool(5)));
  }

  private static Outcome addReadWrite(Call<ControlBox> call) throws ScriptError {
    int readCount = call.integer(3, 1, ModbusExchange.MOST);
    int writeCount = call.integer(5, 1, ModbusExchange.MOST);
    if (writeCount > MAX_WRITTEN) {
      throw call.refuse(5, text("written", MAX_WRITTEN));
    }
    return add(
        call,
        ModbusArguments.newName(call, 6),
        new ModbusExchange(
            ModbusArguments.address(call, 0),
            call.integer(1, 0, MAX_UNIT),
            ModbusKind.READ_WRITE_REGISTERS,
            address(call, 2, readCount),
            readCount,
            address(call, 4, writeCount),
            writeCount,
            call.bool(7)));
  }

  private static int address(Call<ControlBox> call, int index, int count) throws ScriptError {
    int address = call.integer(index, 0, MAX_ADDRESS);
    if (address + count - 1 > MAX_ADDRESS) {
      throw call.refuse(index, text("room", count, MAX_ADDRESS));
    }
    return address;
  }

  private static Outcome add(Call<ControlBox> call, String name, ModbusExchange exchange)
      throws ScriptError {
    try {
      call.host().links().modbus().add(name, exchange);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
    return call.answer();
  }

  private static Outcome delete(Call<ControlBox> call) throws ScriptError {
    call.host().links().modbus().delete(ModbusArguments.signal(call).name());
    return call.answer();
  }

  private static Outcome status(Call<ControlBox> call) throws ScriptError {
    ModbusArguments.refuseInternalFlag(call, 1);
    ModbusSignal signal = ModbusArguments.signal(call);
    if (signal.updateHz() == 0) {
      signal.update();
    }
    double nowS = call.host().clock().timeS();
    if (signal.lost(nowS)) {
      throw call.failure(
          "signal-invalid",
          text(
              "signalInvalid",
              signal.name(),
              Math.round(signal.invalidS(nowS) * 1000) / 1000.0,
              ModbusErrors.of(signal.reading())));
    }
    List<Integer> values = signal.values();
    boolean digital = signal.exchange().kind().digital();
    if (values.size() > 1) {
      return call.answer(list(values, digital ? ValueKind.BOOL : ValueKind.INT));
    }
    return digital ? call.answer(values.getFirst() != 0) : call.answerInt(values.getFirst());
  }

  private static NumberList list(List<Integer> values, ValueKind kind) {
    double[] numbers = new double[values.size()];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = values.get(i);
    }
    return NumberList.owning(numbers, numbers.length, kind);
  }

  private static Outcome update(Call<ControlBox> call) throws ScriptError {
    ModbusArguments.signal(call).update();
    return call.answer();
  }

  private static Outcome setFrequency(Call<ControlBox> call) throws ScriptError {
    ModbusSignal signal = ModbusArguments.signal(call);
    signal.setUpdateHz(Math.max(0, call.integer(1, -1, MAX_HZ)));
    return call.answer();
  }

  private static Outcome error(Call<ControlBox> call) throws ScriptError {
    ModbusReading reading = ModbusArguments.signal(call).reading();
    return call.answerInt(
        switch (call.integer(1, 0, 2)) {
          case 1 -> reading.deviceError();
          case 2 -> reading.connectionError();
          default -> (reading.connectionError() << Short.SIZE) | (reading.deviceError() & 0xFFFF);
        });
  }

  private static Outcome setWatchdog(Call<ControlBox> call) throws ScriptError {
    ModbusSignal signal = ModbusArguments.signal(call);
    double timeoutS = call.number(1);
    if (!(timeoutS >= 0 && timeoutS <= MAX_WATCHDOG_S)) {
      throw call.refuse(1, text("zeroTo", MAX_WATCHDOG_S));
    }
    signal.setWatchdogS(timeoutS);
    return call.answer();
  }
}
