package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.SignalId;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.RunStateOutputs;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.io.Signals;

/**
 * Signal setup: sets up the signals of a box as an installation says. The frame loop alone uses it.
 */
final class InstalledSignals {
  private final ControlBox box;
  private final Signals signals;

  InstalledSignals(ControlBox box) {
    this.box = box;
    signals = box.signals();
  }

  /** Wiring, actions of inputs, and what outputs do when programs start and end. */
  void apply(Installation installation) {
    wire(installation.wiring());
    clearActions();
    installation.signals().forEach(this::use);
  }

  private void wire(Wiring wiring) {
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      signals.write(new SignalWrite.Domain(AnalogBank.STANDARD_IN, i, wiring.analogIn().get(i)));
      signals.write(new SignalWrite.Domain(AnalogBank.STANDARD_OUT, i, wiring.analogOut().get(i)));
      signals.write(new SignalWrite.Domain(AnalogBank.TOOL_IN, i, wiring.toolAnalogIn().get(i)));
      signals.write(new SignalWrite.ToolPin(i, wiring.toolPins().get(i)));
    }
    signals.write(new SignalWrite.ToolVoltage(wiring.toolVoltage()));
    signals.write(new SignalWrite.ToolOutputs(wiring.toolOutputMode()));
    if (!signals.tool().communication().equals(wiring.toolCommunication())) {
      var _ = box.links().toolLine().setUp(wiring.toolCommunication());
    }
  }

  private void clearActions() {
    signals.clearActions();
    RunStateOutputs outputs = signals.runState();
    for (SignalBank bank : SignalBank.values()) {
      for (int i = 0; i < bank.size() && !bank.input() && bank != SignalBank.FLAG; i++) {
        outputs.choose(new Signal(bank, i), RunStateAction.PRESERVE);
      }
    }
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      outputs.chooseAnalog(i, RunStateAction.PRESERVE);
    }
    for (int i = 0; i < RegisterKind.BOOLEAN.size(); i++) {
      outputs.chooseRegister(i, RunStateAction.PRESERVE);
    }
  }

  private void use(SignalUse use) {
    Optional<SignalId> id = SignalId.of(use.signal());
    if (id.isEmpty()) {
      box.log().warning(text("noSignal", use.signal()));
      return;
    }
    switch (id.get()) {
      case SignalId.Digital digital -> use(digital.signal(), use);
      case SignalId.Analog analog -> {
        if (analog.bank() == AnalogBank.STANDARD_OUT) {
          signals.runState().chooseAnalog(analog.index(), use.output());
        }
      }
      case SignalId.Register register -> {
        if (register.kind() == RegisterKind.BOOLEAN) {
          use(register, use);
        }
      }
    }
  }

  private void use(Signal signal, SignalUse use) {
    if (signal.bank().input()) {
      if (use.input() != InputAction.DEFAULT) {
        signals.setAction(signal, use.input());
      }
    } else if (signal.bank() != SignalBank.FLAG) {
      signals.runState().choose(signal, use.output());
    }
  }

  private void use(SignalId.Register register, SignalUse use) {
    if (register.direction() == RegisterDirection.INPUT) {
      signals.setRegisterAction(register.address(), use.input());
    } else {
      signals.runState().chooseRegister(register.address(), use.output());
    }
  }
}
