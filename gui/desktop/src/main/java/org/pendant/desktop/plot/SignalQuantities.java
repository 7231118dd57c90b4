package org.pendant.desktop.plot;

import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.state.ControllerState;

/** The inputs, outputs, flags and registers that can be drawn. */
final class SignalQuantities {
  private final Function<String, String> names;
  private final Consumer<Quantity> found;

  /**
   * Tells {@code found} of each.
   *
   * @param names what people call a signal, by an id such as {@code digital-in-0}; empty text for
   *     none
   */
  SignalQuantities(Function<String, String> names, Consumer<Quantity> found) {
    this.names = names;
    this.found = found;
  }

  void addAll() {
    for (SignalBank bank : SignalBank.values()) {
      addDigital(bank);
    }
    for (AnalogBank bank : AnalogBank.values()) {
      addAnalog(bank);
    }
    add("tool_voltage", "Signals/Tool", "Tool voltage", "V", s -> s.signals().tool().voltageV());
    for (RegisterDirection direction : RegisterDirection.values()) {
      for (RegisterKind kind : RegisterKind.values()) {
        addRegisters(direction, kind);
      }
    }
  }

  private void add(
      String id, String group, String name, String unit, ToDoubleFunction<ControllerState> value) {
    Supplier<String> given = () -> names.apply(id.replace('_', '-'));
    found.accept(new Quantity(id, group, name, name, unit, value, given));
  }

  private void addDigital(SignalBank bank) {
    for (int i = 0; i < bank.size(); i++) {
      int index = i;
      add(
          bank.text() + "_" + i,
          "Signals/" + titleOf(bank),
          bank.text() + "[" + i + "]",
          Quantity.DIGITAL,
          state -> state.io().bits(bank) >> index & 1);
    }
  }

  private void addAnalog(AnalogBank bank) {
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      int index = i;
      add(
          bank.text() + "_" + i,
          "Signals/" + titleOf(bank),
          bank.name(i),
          "V or mA",
          state -> value(state.signals().analog().signal(bank, index)));
    }
  }

  private static double value(AnalogSignal signal) {
    return signal.domain() == AnalogDomain.CURRENT ? 1e3 * signal.value() : signal.value();
  }

  private void addRegisters(RegisterDirection direction, RegisterKind kind) {
    String group = "Registers/" + capital(direction.text()) + "s, " + kind.text();
    for (int i = 0; i < kind.size(); i++) {
      int address = i;
      add(
          direction.text() + "_" + kind.text() + "_register_" + i,
          group,
          direction.name(kind, i),
          kind == RegisterKind.BOOLEAN ? Quantity.DIGITAL : "",
          state -> value(state.signals().registers(direction), kind, address));
    }
  }

  private static double value(RegisterLevels levels, RegisterKind kind, int address) {
    return switch (kind) {
      case BOOLEAN -> levels.bool(address) ? 1 : 0;
      case INTEGER -> levels.integer(address);
      case FLOAT -> levels.floating(address);
    };
  }

  private static String capital(String word) {
    return word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
  }

  private static String titleOf(AnalogBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "Analog inputs";
      case STANDARD_OUT -> "Analog outputs";
      case TOOL_IN -> "Analog tool inputs";
    };
  }

  private static String titleOf(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "Digital inputs";
      case STANDARD_OUT -> "Digital outputs";
      case CONFIGURABLE_IN -> "Configurable inputs";
      case CONFIGURABLE_OUT -> "Configurable outputs";
      case TOOL_IN -> "Tool inputs";
      case TOOL_OUT -> "Tool outputs";
      case FLAG -> "Flags";
    };
  }
}
