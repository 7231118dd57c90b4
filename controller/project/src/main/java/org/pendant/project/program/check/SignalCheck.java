package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.SignalBank;
import org.pendant.project.program.ProgramNode;

/** Signal check: checks that signals exist and are of the kind that a node needs. */
final class SignalCheck {
  private static final Pattern NAME = Pattern.compile("(\\w+)\\[(\\d{1,3})\\]");

  private final CheckContext findings;

  SignalCheck(CheckContext findings) {
    this.findings = findings;
  }

  /** What a signal is. */
  private record Found(boolean digital, boolean output) {}

  /** A signal with a level that can be read. */
  void digital(ProgramNode node, String field, String signal) {
    find(node, field, signal)
        .filter(found -> !found.digital())
        .ifPresent(found -> findings.problem(node, field, text("notDigital", signal)));
  }

  /** A signal with a value that can be read. */
  void analog(ProgramNode node, String field, String signal) {
    find(node, field, signal)
        .filter(Found::digital)
        .ifPresent(found -> findings.problem(node, field, text("notAnalog", signal)));
  }

  /** A digital signal that can be set. */
  void digitalOut(ProgramNode node, String field, String signal) {
    find(node, field, signal)
        .filter(found -> !(found.digital() && found.output()))
        .ifPresent(found -> findings.problem(node, field, text("noDigitalOutput", signal)));
  }

  /** An analog signal that can be set. */
  void analogOut(ProgramNode node, String field, String signal) {
    find(node, field, signal)
        .filter(found -> found.digital() || !found.output())
        .ifPresent(found -> findings.problem(node, field, text("noAnalogOutput", signal)));
  }

  /** Any signal that can be set. */
  void output(ProgramNode node, String field, String signal) {
    find(node, field, signal)
        .filter(found -> !found.output())
        .ifPresent(found -> findings.problem(node, field, text("cannotBeSet", signal)));
  }

  private Optional<Found> find(ProgramNode node, String field, String signal) {
    if (signal.isBlank()) {
      findings.problem(node, field, text("signalMissing"));
      return Optional.empty();
    }
    Optional<Found> found = box(signal).or(() -> modbus(signal));
    if (found.isEmpty()) {
      findings.problem(node, field, text("noSuchSignal", signal));
    }
    return found;
  }

  private static Optional<Found> box(String signal) {
    Matcher parts = NAME.matcher(signal);
    if (!parts.matches()) {
      return Optional.empty();
    }
    int index = Integer.parseInt(parts.group(2));
    for (SignalBank bank : SignalBank.values()) {
      if (bank.text().equals(parts.group(1))) {
        return index < bank.size() ? Optional.of(new Found(true, !bank.input())) : Optional.empty();
      }
    }
    for (AnalogBank bank : AnalogBank.values()) {
      if (bank.text().equals(parts.group(1))) {
        return index < AnalogBank.SIZE
            ? Optional.of(new Found(false, !bank.input()))
            : Optional.empty();
      }
    }
    return register(parts.group(1), index);
  }

  private static Optional<Found> register(String bank, int index) {
    for (RegisterKind kind : RegisterKind.values()) {
      boolean output = bank.equals("output_" + kind.text() + "_register");
      if (output || bank.equals("input_" + kind.text() + "_register")) {
        return index < kind.size()
            ? Optional.of(new Found(kind == RegisterKind.BOOLEAN, output))
            : Optional.empty();
      }
    }
    return Optional.empty();
  }

  private Optional<Found> modbus(String signal) {
    return findings.installation().modbus().stream()
        .filter(each -> each.name().equals(signal))
        .findFirst()
        .map(ModbusSetup::kind)
        .map(kind -> new Found(kind.digital(), kind.output()));
  }
}
