package org.pendant.desktop.io;

import static org.pendant.desktop.io.IoTexts.text;

import java.util.List;
import java.util.stream.Collectors;
import org.pendant.controller.external.ModbusErrors;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.external.ModbusReading;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.kit.text.Messages;
import org.pendant.language.source.ByteText;

/**
 * Modbus row: a signal as it is shown.
 *
 * @param name what programs call it
 * @param place what it reads or writes, and where
 * @param value of all its bits or registers
 * @param status whether the device answers, and what is wrong if not
 * @param wrong whether something is
 * @param rate how often
 */
record ModbusRow(
    String name, String place, String value, String status, boolean wrong, String rate) {

  /** The rows of all signals, in their order. */
  static List<ModbusRow> of(List<ModbusSignalState> signals) {
    return signals.stream().map(ModbusRow::of).toList();
  }

  private static ModbusRow of(ModbusSignalState signal) {
    ModbusExchange exchange = signal.exchange();
    return new ModbusRow(
        ByteText.decoded(signal.name()),
        text(
            "modbusPlace",
            Messages.shown(exchange.kind().words()),
            exchange.readAddress(),
            exchange.unit(),
            ByteText.decoded(exchange.device().toString())),
        value(signal),
        status(signal),
        !signal.valid(),
        signal.updateHz() == 0 ? text("onDemand") : text("modbusRate", signal.updateHz()));
  }

  private static String value(ModbusSignalState signal) {
    boolean single = signal.values().size() == 1;
    if (single && signal.exchange().kind().digital()) {
      return signal.values().getFirst() == 0 ? text("low") : text("high");
    }
    return signal.values().isEmpty()
        ? "\u2013"
        : signal.values().stream().map(String::valueOf).collect(Collectors.joining(", "));
  }

  private static String status(ModbusSignalState signal) {
    String problem =
        ModbusErrors.of(
            new ModbusReading(signal.values(), signal.deviceError(), signal.connectionError()));
    return !problem.isEmpty() ? problem : signal.valid() ? text("answered") : text("noAnswerYet");
  }
}
