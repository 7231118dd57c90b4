package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.project.polyscope.xml.XmlElement;

/**
 * Signal reader: takes names and actions of signals, and signals of Modbus devices, out of the
 * element IOs.
 */
final class SignalReader {
  private static final String NAMES = "Names";
  private static final String ACTIONS = "Actions";
  private static final String NO_ACTION = "NONE";

  /**
   * Names and actions of signals, one after the other, and what the signals are called here. Each
   * begins the names of two elements.
   */
  private static final List<Bank> BANKS =
      List.of(
          new Bank("DigitalInput", "digital_in", 8),
          new Bank("DigitalOutput", "digital_out", 8),
          new Bank("ConfigurableInput", "configurable_in", 8),
          new Bank("ConfigurableOutput", "configurable_out", 8),
          new Bank("ToolDigitalInput", "tool_in", 2),
          new Bank("ToolDigitalOutput", "tool_out", 2),
          new Bank("AnalogInput", "analog_in", 2),
          new Bank("AnalogOutput", "analog_out", 2),
          new Bank("ToolAnalogInput", "tool_analog_in", 2),
          new Bank("GeneralPurposeBooleanRegisterInput", "input_boolean_register", 128),
          new Bank("GeneralPurposeBooleanRegisterOutput", "output_boolean_register", 128),
          new Bank("GeneralPurposeIntRegisterInput", "input_integer_register", 48),
          new Bank("GeneralPurposeIntRegisterOutput", "output_integer_register", 48),
          new Bank("GeneralPurposeFloatRegisterInput", "input_float_register", 48),
          new Bank("GeneralPurposeFloatRegisterOutput", "output_float_register", 48));

  private static final Map<String, RunStateAction> OUTPUT_ACTIONS =
      Map.of(
          NO_ACTION,
          RunStateAction.PRESERVE,
          "LOW_WHEN_PROGRAM_STOPPED",
          RunStateAction.LOW_WHEN_NOT_RUNNING,
          "HIGH_WHEN_PROGRAM_STOPPED",
          RunStateAction.HIGH_WHEN_NOT_RUNNING);

  private static final Map<String, InputAction> INPUT_ACTIONS =
      Map.of(NO_ACTION, InputAction.DEFAULT, "FREEDRIVE", InputAction.FREEDRIVE);

  private record Bank(String element, String name, int size) {
    boolean input() {
      return element.endsWith("Input");
    }
  }

  private final Optional<XmlElement> ios;
  private final List<String> remarks;

  SignalReader(Optional<XmlElement> ios, List<String> remarks) {
    this.ios = ios;
    this.remarks = remarks;
  }

  /** Signals that have a name or do something by themselves. */
  List<SignalUse> signals() {
    List<SignalUse> uses = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (Bank bank : BANKS) {
      List<String> called = Rows.words(ios, bank.element() + NAMES);
      List<String> actions = Rows.words(ios, bank.element() + ACTIONS);
      for (int i = 0; i < bank.size(); i++) {
        String signal = bank.name() + "[" + i + "]";
        String name = i < called.size() ? called.get(i) : "";
        if (!name.isEmpty() && !names.add(name)) {
          remarks.add(text("calledAsWell", signal, name));
        }
        SignalUse use = use(bank, signal, name, i < actions.size() ? actions.get(i) : NO_ACTION);
        boolean idle =
            use.input() == InputAction.DEFAULT && use.output() == RunStateAction.PRESERVE;
        if (!name.isEmpty() || !idle) {
          uses.add(use);
        }
      }
    }
    return uses;
  }

  private SignalUse use(Bank bank, String signal, String name, String action) {
    boolean known = (bank.input() ? INPUT_ACTIONS : OUTPUT_ACTIONS).containsKey(action);
    if (!known) {
      remarks.add(text("actionUnknown", action, signal));
    }
    return new SignalUse(
        signal,
        name,
        bank.input()
            ? INPUT_ACTIONS.getOrDefault(action, InputAction.DEFAULT)
            : InputAction.DEFAULT,
        bank.input()
            ? RunStateAction.PRESERVE
            : OUTPUT_ACTIONS.getOrDefault(action, RunStateAction.PRESERVE));
  }

  /** Signals at other devices. */
  List<ModbusSetup> modbus() {
    List<ModbusSetup> signals = new ArrayList<>();
    List<XmlElement> units =
        ios.flatMap(each -> each.child("ModbusUnits"))
            .map(each -> each.children("Unit"))
            .orElse(List.of());
    Set<String> names = new HashSet<>();
    for (XmlElement unit : units) {
      for (XmlElement each : unit.children("ModbusSignal")) {
        Optional<ModbusSetup> signal = modbus(unit.text("ipAddress"), each);
        if (signal.isPresent() && names.add(signal.get().name())) {
          signals.add(signal.get());
        } else if (signal.isPresent()) {
          remarks.add(text("atLine", each.line(), text("modbusTwice", signal.get().name())));
        } else {
          remarks.add(text("atLine", each.line(), text("modbusIncomplete")));
        }
      }
    }
    return signals;
  }

  private Optional<ModbusSetup> modbus(String device, XmlElement signal) {
    Optional<ModbusKind> kind =
        List.of(ModbusKind.values()).stream()
            .filter(each -> each.name().equals(signal.text("type")))
            .findFirst();
    double[] address = Rows.numbers(signal.text("signalAddress"), 1);
    double[] unit = Rows.numbers(signal.attribute("slaveAddress").orElse("255"), 1);
    double[] updateHz = Rows.numbers(signal.text("updateFrequency"), 1);
    boolean whole =
        kind.isPresent()
            && !device.isBlank()
            && !signal.text("name").isBlank()
            && address.length + unit.length + updateHz.length == 3;
    for (String action : List.of("inputAction", "outputAction")) {
      String does = signal.attribute(action).orElse(NO_ACTION);
      if (!does.equals(NO_ACTION)) {
        remarks.add(text("modbusActionLeftOut", does, signal.text("name")));
      }
    }
    return whole
        ? Optional.of(
            new ModbusSetup(
                signal.text("name"),
                device,
                (int) unit[0],
                kind.get(),
                (int) address[0],
                (int) updateHz[0]))
        : Optional.empty();
  }
}
