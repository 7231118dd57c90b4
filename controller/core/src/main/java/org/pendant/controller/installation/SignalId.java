package org.pendant.controller.installation;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;

/** Signal identifier: a signal that an installation can name, as in {@link SignalUse#signal}. */
public sealed interface SignalId {
  /** A digital input, output or flag. */
  record Digital(Signal signal) implements SignalId {
    @Override
    public boolean takesInputAction() {
      return signal.bank().input();
    }

    @Override
    public boolean takesOutputAction() {
      return !signal.bank().input() && signal.bank() != SignalBank.FLAG;
    }
  }

  /** An analog input or output. */
  record Analog(AnalogBank bank, int index) implements SignalId {
    @Override
    public boolean takesInputAction() {
      return false;
    }

    @Override
    public boolean takesOutputAction() {
      return !bank.input();
    }
  }

  /** A general-purpose register. */
  record Register(RegisterDirection direction, RegisterKind kind, int address) implements SignalId {
    @Override
    public boolean takesInputAction() {
      return kind == RegisterKind.BOOLEAN && direction == RegisterDirection.INPUT;
    }

    @Override
    public boolean takesOutputAction() {
      return kind == RegisterKind.BOOLEAN && direction == RegisterDirection.OUTPUT;
    }
  }

  /** Whether a high level of it can do something by itself. */
  boolean takesInputAction();

  /** Whether it can follow what programs do. */
  boolean takesOutputAction();

  /** The signal of a name such as {@code digital_in[0]} or {@code output_float_register[3]}. */
  static Optional<SignalId> of(String name) {
    Matcher parts = Pattern.compile("(\\w+)\\[(\\d{1,3})\\]").matcher(name);
    if (!parts.matches()) {
      return Optional.empty();
    }
    String bank = parts.group(1);
    int index = Integer.parseInt(parts.group(2));
    for (SignalBank each : SignalBank.values()) {
      if (each.text().equals(bank) && index < each.size()) {
        return Optional.of(new Digital(new Signal(each, index)));
      }
    }
    for (AnalogBank each : AnalogBank.values()) {
      if (each.text().equals(bank) && index < AnalogBank.SIZE) {
        return Optional.of(new Analog(each, index));
      }
    }
    for (RegisterDirection direction : RegisterDirection.values()) {
      for (RegisterKind kind : RegisterKind.values()) {
        if (index < kind.size() && direction.name(kind, index).equals(name)) {
          return Optional.of(new Register(direction, kind, index));
        }
      }
    }
    return Optional.empty();
  }

  /** The digital input of a name; empty if it names something else. */
  static Optional<Signal> digitalInput(String name) {
    return of(name)
        .filter(found -> found instanceof Digital digital && digital.signal().bank().input())
        .map(found -> ((Digital) found).signal());
  }
}
