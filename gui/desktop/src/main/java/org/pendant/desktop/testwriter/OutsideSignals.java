package org.pendant.desktop.testwriter;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.RegisterLevels;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;

/** Outside signals: what the world outside has set, as a test would set it. */
final class OutsideSignals {
  private static final List<SignalBank> OUTPUTS =
      List.of(SignalBank.STANDARD_OUT, SignalBank.CONFIGURABLE_OUT, SignalBank.TOOL_OUT);
  private static final List<SignalBank> INPUTS =
      List.of(SignalBank.STANDARD_IN, SignalBank.CONFIGURABLE_IN, SignalBank.TOOL_IN);

  private OutsideSignals() {}

  /** What inputs are that are not as when a box is switched on, and which outputs are high. */
  static List<SignalWrite> set(ControllerState state) {
    List<SignalWrite> writes = new ArrayList<>();
    for (SignalBank bank : INPUTS) {
      high(state, bank, writes);
    }
    analog(state, writes);
    registers(RegisterLevels.ZERO, state.signals().inputs(), writes);
    for (SignalBank bank : OUTPUTS) {
      high(state, bank, writes);
    }
    return writes;
  }

  private static void high(ControllerState state, SignalBank bank, List<SignalWrite> writes) {
    for (int i = 0; i < bank.size(); i++) {
      Signal signal = new Signal(bank, i);
      if (state.io().level(signal)) {
        writes.add(new SignalWrite.Digital(signal, true));
      }
    }
  }

  private static void analog(ControllerState state, List<SignalWrite> writes) {
    for (AnalogBank bank : AnalogBank.values()) {
      for (int i = 0; bank.input() && i < AnalogBank.SIZE; i++) {
        AnalogSignal now = state.signals().analog().signal(bank, i);
        if (now.value() != now.domain().low()) {
          writes.add(new SignalWrite.AnalogInput(bank, i, now.value(), now.domain()));
        }
      }
    }
  }

  /** The inputs that are others than in an earlier state. */
  static List<SignalWrite> changed(ControllerState before, ControllerState now) {
    List<SignalWrite> writes = new ArrayList<>();
    for (Signal each : changed(INPUTS, before, now)) {
      writes.add(new SignalWrite.Digital(each, now.io().level(each)));
    }
    if (!now.signals().equals(before.signals())) {
      analog(before, now, writes);
      registers(before.signals().inputs(), now.signals().inputs(), writes);
    }
    return writes;
  }

  /** The outputs that are others than in an earlier state. */
  static List<Signal> changedOutputs(ControllerState before, ControllerState now) {
    return changed(OUTPUTS, before, now);
  }

  private static List<Signal> changed(
      List<SignalBank> banks, ControllerState before, ControllerState now) {
    if (now.io().equals(before.io())) {
      return List.of();
    }
    List<Signal> changed = new ArrayList<>();
    for (SignalBank bank : banks) {
      int bits = now.io().bits(bank) ^ before.io().bits(bank);
      for (int i = 0; i < bank.size(); i++) {
        if ((bits >> i & 1) != 0) {
          changed.add(new Signal(bank, i));
        }
      }
    }
    return changed;
  }

  private static void analog(
      ControllerState before, ControllerState now, List<SignalWrite> writes) {
    for (AnalogBank bank : AnalogBank.values()) {
      for (int i = 0; bank.input() && i < AnalogBank.SIZE; i++) {
        AnalogSignal old = before.signals().analog().signal(bank, i);
        AnalogSignal fresh = now.signals().analog().signal(bank, i);
        AnalogDomain domain = fresh.domain();
        // another domain reads another wire, on which nothing need have changed
        if (domain == old.domain() && fresh.value() != old.value()) {
          writes.add(new SignalWrite.AnalogInput(bank, i, fresh.value(), domain));
        }
      }
    }
  }

  private static void registers(
      RegisterLevels before, RegisterLevels now, List<SignalWrite> writes) {
    if (now.equals(before)) {
      return;
    }
    RegisterDirection input = RegisterDirection.INPUT;
    for (int i = 0; i < RegisterKind.BOOLEAN.size(); i++) {
      if (now.bool(i) != before.bool(i)) {
        writes.add(new SignalWrite.BooleanRegister(input, i, now.bool(i)));
      }
    }
    for (int i = 0; i < RegisterKind.INTEGER.size(); i++) {
      if (now.integer(i) != before.integer(i)) {
        writes.add(new SignalWrite.IntegerRegister(input, i, now.integer(i)));
      }
    }
    for (int i = 0; i < RegisterKind.FLOAT.size(); i++) {
      if (Double.compare(now.floating(i), before.floating(i)) != 0) {
        writes.add(new SignalWrite.FloatRegister(input, i, now.floating(i)));
      }
    }
  }
}
