package org.pendant.controller.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import org.pendant.controller.external.ModbusExchange;

/**
 * Modbus device that a test plays: coils, inputs and registers at all addresses, 0 until somebody
 * sets them, whatever number of a unit programs ask for. It lives in robot time; nothing of it is a
 * real connection.
 */
public final class ModbusDevice {
  /** Most requests of a program's own that are kept; more are only counted. */
  public static final int MAX_KEPT = 10_000;

  /** What the values of a device are. */
  public enum Table {
    COILS,
    INPUTS,
    REGISTERS,
    INPUT_REGISTERS
  }

  private final Map<Table, Map<Integer, Integer>> tables = new HashMap<>();
  private final List<List<Integer>> commands = new ArrayList<>();
  private long requests;
  private long delayFrames;
  private int exception;
  private boolean silent;
  private boolean refuses;

  ModbusDevice() {}

  /** A value, bits as 0 and 1. */
  public int value(Table table, int address) {
    return tables.getOrDefault(table, Map.of()).getOrDefault(address, 0);
  }

  /** Sets values from an address on, bits as 0 and 1. */
  public void set(Table table, int address, List<Integer> values) {
    Map<Integer, Integer> all = tables.computeIfAbsent(table, _ -> new HashMap<>());
    for (int i = 0; i < values.size(); i++) {
      all.put(address + i, values.get(i));
    }
  }

  /** Has answers come so many frames later, 0 or more. */
  public void setDelayFrames(long frames) {
    delayFrames = frames;
  }

  /** Has each request answered with an exception from now on; 0 for with what it asks for. */
  public void setException(int code) {
    exception = code;
  }

  /** Has no request answered from now on, or each again. */
  public void setSilent(boolean saysNothing) {
    silent = saysNothing;
  }

  /** Has connections refused from now on, those that there are included, or accepted again. */
  public void setRefuses(boolean refuse) {
    refuses = refuse;
  }

  /** How many requests have come. */
  public long requests() {
    return requests;
  }

  /** The requests that programs have made of bytes: unit, function, and what follows. */
  public List<List<Integer>> commands() {
    return commands;
  }

  long delayFrames() {
    return delayFrames;
  }

  boolean silent() {
    return silent;
  }

  boolean refuses() {
    return refuses;
  }

  /** The exception that a request is answered with, where it is. */
  OptionalInt exception() {
    return exception == 0 ? OptionalInt.empty() : OptionalInt.of(exception);
  }

  /**
   * A request has come; what it writes is written unless the device does not do what it is asked.
   */
  void ask(ModbusExchange exchange, List<Integer> written) {
    requests++;
    if (!written.isEmpty() && obeys()) {
      set(
          exchange.kind().digital() ? Table.COILS : Table.REGISTERS,
          exchange.writeAddress(),
          written);
    }
  }

  private boolean obeys() {
    return !silent && exception == 0;
  }

  /** What an exchange reads. */
  List<Integer> read(ModbusExchange exchange) {
    Table table =
        switch (exchange.kind()) {
          case DIGITAL_INPUT -> Table.INPUTS;
          case DIGITAL_OUTPUT, DIGITAL_OUTPUTS -> Table.COILS;
          case REGISTER_INPUT -> Table.INPUT_REGISTERS;
          case REGISTER_OUTPUT, REGISTER_OUTPUTS, READ_WRITE_REGISTERS -> Table.REGISTERS;
        };
    List<Integer> values = new ArrayList<>();
    for (int i = 0; i < exchange.readCount(); i++) {
      values.add(value(table, exchange.readAddress() + i));
    }
    return values;
  }

  /** A request that a program has made of bytes. */
  void command(int unit, int function, byte[] data) {
    requests++;
    if (commands.size() < MAX_KEPT) {
      List<Integer> bytes = new ArrayList<>(List.of(unit, function));
      for (byte each : data) {
        bytes.add(each & 0xFF);
      }
      commands.add(List.copyOf(bytes));
    }
    if (obeys()) {
      ModbusCommand.of(function, data).ifPresent(each -> each.into(this));
    }
  }
}
