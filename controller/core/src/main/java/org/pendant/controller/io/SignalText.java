package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Signals and levels as people write them on a command line. */
public final class SignalText {
  private static final Pattern NAME = Pattern.compile("(\\w+)\\[(\\d{1,3})\\]");
  private static final Pattern AMOUNT = Pattern.compile("(-?[0-9.eE+-]+) ?(V|mA|A)");

  private SignalText() {}

  /**
   * The changes that make an input what people say. An analog input also gets the domain of the
   * unit.
   *
   * @param name such as {@code digital_in[0]}, {@code analog_in[1]}, {@code
   *     input_float_register[3]} or {@code port_register[128]}
   * @param value {@code true}, {@code 12}, {@code 0.5}, {@code 5V}, {@code 12mA}
   * @throws UnknownSignal if there is no such input
   * @throws IllegalArgumentException if it does not take the value
   */
  public static List<SignalWrite> input(String name, String value) {
    Matcher parts = NAME.matcher(name);
    if (!parts.matches()) {
      throw unknown(name);
    }
    String bank = parts.group(1);
    int index = Integer.parseInt(parts.group(2));
    for (AnalogBank analog : AnalogBank.values()) {
      if (analog.input() && analog.text().equals(bank)) {
        return analog(analog, index, value);
      }
    }
    for (SignalBank digital : SignalBank.values()) {
      if (digital.input() && digital.text().equals(bank)) {
        return List.of(new SignalWrite.Digital(new Signal(digital, index), level(value)));
      }
    }
    return List.of(memory(name, bank, index, value).orElseThrow(() -> unknown(name)));
  }

  private static Optional<SignalWrite> memory(String name, String bank, int address, String value) {
    return switch (bank) {
      case "input_boolean_register" ->
          Optional.of(
              new SignalWrite.BooleanRegister(RegisterDirection.INPUT, address, level(value)));
      case "input_integer_register" ->
          Optional.of(
              new SignalWrite.IntegerRegister(
                  RegisterDirection.INPUT,
                  address,
                  integer(name, value, Integer.MIN_VALUE, Integer.MAX_VALUE)));
      case "input_float_register" ->
          Optional.of(
              new SignalWrite.FloatRegister(RegisterDirection.INPUT, address, number(name, value)));
      case "port_register" ->
          Optional.of(
              new SignalWrite.PortRegister(
                  address, (short) integer(name, value, Short.MIN_VALUE, 0xFFFF)));
      case "port_bit" -> Optional.of(new SignalWrite.PortBit(address, level(value)));
      default -> Optional.empty();
    };
  }

  private static List<SignalWrite> analog(AnalogBank bank, int index, String text) {
    Matcher amount = AMOUNT.matcher(text);
    if (!amount.matches()) {
      throw new IllegalArgumentException(text("analogWithoutUnit", bank.name(index), text));
    }
    double number = number(bank.name(index), amount.group(1));
    AnalogDomain domain = amount.group(2).equals("V") ? AnalogDomain.VOLTAGE : AnalogDomain.CURRENT;
    double value = amount.group(2).equals("mA") ? number / 1000 : number;
    List<SignalWrite> writes = new ArrayList<>();
    writes.add(new SignalWrite.Domain(bank, index, domain));
    writes.add(new SignalWrite.AnalogInput(bank, index, value, domain));
    return writes;
  }

  /**
   * A digital level.
   *
   * @throws IllegalArgumentException if the text says none
   */
  public static boolean level(String text) {
    return switch (text) {
      case "true", "True", "1" -> true;
      case "false", "False", "0" -> false;
      default -> throw new IllegalArgumentException(text("level", text));
    };
  }

  private static int integer(String name, String text, int low, int high) {
    try {
      long number = Long.parseLong(text);
      if (number >= low && number <= high) {
        return (int) number;
      }
    } catch (NumberFormatException e) {
      // the message below says what is wrong with it
    }
    throw new IllegalArgumentException(text("wholeNumber", name, text, low, high));
  }

  private static double number(String name, String text) {
    try {
      double number = Double.parseDouble(text);
      if (Double.isFinite(number)) {
        return number;
      }
    } catch (NumberFormatException e) {
      // the message below says what is wrong with it
    }
    throw new IllegalArgumentException(text("number", name, text));
  }

  private static UnknownSignal unknown(String name) {
    StringBuilder names = new StringBuilder();
    for (SignalBank bank : SignalBank.values()) {
      if (bank.input()) {
        names.append(bank.text()).append("[0] to [").append(bank.size() - 1).append("], ");
      }
    }
    for (AnalogBank bank : AnalogBank.values()) {
      if (bank.input()) {
        names.append(bank.text()).append("[0] to [").append(AnalogBank.SIZE - 1).append("], ");
      }
    }
    for (RegisterKind kind : RegisterKind.values()) {
      names.append("input_").append(kind.text()).append("_register[0] to [");
      names.append(kind.size() - 1).append("], ");
    }
    names.append("port_register[128] to [255], port_bit[128] to [255]");
    return new UnknownSignal(text("unknownInput", name, names));
  }
}
