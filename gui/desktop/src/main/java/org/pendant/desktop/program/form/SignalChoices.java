package org.pendant.desktop.program.form;

import static org.pendant.desktop.program.form.FormTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.SignalBank;
import org.pendant.desktop.program.form.Item.Option;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.NumberRange;

/**
 * Signal choices: the signals that a node can be about, with the names that the installation gives
 * them.
 */
record SignalChoices(Installation installation) {
  private static final NumberRange REGISTER = NumberRange.of(0, 65_535);

  /** Digital inputs. */
  List<Option> digitalInputs() {
    return digital(SignalBank::input, kind -> kind.kind().digital() && !kind.kind().output());
  }

  /** Digital outputs and flags. */
  List<Option> digitalOutputs() {
    return digital(bank -> !bank.input(), kind -> kind.kind().digital() && kind.kind().output());
  }

  /** All digital signals, inputs first. */
  List<Option> digital() {
    List<Option> all = new ArrayList<>(digitalInputs());
    all.addAll(digitalOutputs());
    return all;
  }

  private List<Option> digital(Predicate<SignalBank> banks, Predicate<ModbusSetup> modbus) {
    List<Option> options = new ArrayList<>();
    for (SignalBank bank : SignalBank.values()) {
      if (banks.test(bank)) {
        for (int i = 0; i < bank.size(); i++) {
          options.add(option(bank.text() + "[" + i + "]"));
        }
      }
    }
    addModbus(options, modbus);
    return options;
  }

  /** Analog signals. */
  List<Option> analog() {
    List<Option> options = new ArrayList<>();
    for (AnalogBank bank : AnalogBank.values()) {
      addBank(options, bank);
    }
    addModbus(options, each -> !each.kind().digital());
    return options;
  }

  /** Analog outputs. */
  List<Option> analogOutputs() {
    List<Option> options = new ArrayList<>();
    addBank(options, AnalogBank.STANDARD_OUT);
    addModbus(options, each -> !each.kind().digital() && each.kind().output());
    return options;
  }

  /** Everything that can be set. */
  List<Option> outputs() {
    List<Option> all = new ArrayList<>(digitalOutputs());
    all.addAll(analogOutputs());
    return all;
  }

  private void addBank(List<Option> options, AnalogBank bank) {
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      options.add(option(bank.name(i)));
    }
  }

  private void addModbus(List<Option> options, Predicate<ModbusSetup> which) {
    installation.modbus().stream()
        .filter(which)
        .forEach(each -> options.add(new Option(each.name(), text("modbus", each.name()))));
  }

  private Option option(String signal) {
    String name =
        installation.signals().stream()
            .filter(each -> each.signal().equals(signal))
            .map(SignalUse::name)
            .filter(each -> !each.isEmpty())
            .findFirst()
            .orElse("");
    return new Option(signal, name.isEmpty() ? signal : name + " (" + signal + ")");
  }

  /** The values that an analog signal can have, in A, V or units of a register. */
  NumberRange range(String signal) {
    return NodeFields.domain(signal, installation.wiring())
        .map(domain -> NumberRange.of(domain.low(), domain.high()))
        .orElse(REGISTER);
  }
}
