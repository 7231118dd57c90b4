package org.pendant.desktop.io;

import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.AnalogSignal;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/** Analog presenter: what the screen shows of one analog signal, and what it does. */
final class AnalogPresenter {
  private final AnalogBank bank;
  private final int index;
  private final Forcing forcing;
  private AnalogSignal signal = new AnalogSignal(0, AnalogDomain.VOLTAGE);
  private boolean programRuns;

  AnalogPresenter(AnalogBank bank, int index, Forcing forcing) {
    this.bank = bank;
    this.index = index;
    this.forcing = forcing;
  }

  /** Takes the newest snapshot. */
  void take(ControllerState state) {
    signal = state.signals().analog().signal(bank, index);
    programRuns = state.program().state() != ProgramState.STOPPED;
  }

  /** What it is made of; what was asked for counts before the controller has set it. */
  AnalogDomain domain() {
    return forcing
        .asked(SignalWrite.Domain.class, name())
        .map(SignalWrite.Domain::domain)
        .orElse(signal.domain());
  }

  /** The value, A or V; what was asked for counts before the controller has set it. */
  double value() {
    double value =
        signal.domain() == domain() ? signal.value() : domain().valueAt(bank.input() ? 0 : ratio());
    if (bank.input()) {
      return forcing
          .asked(SignalWrite.AnalogInput.class, name())
          .filter(asked -> asked.domain() == domain())
          .map(SignalWrite.AnalogInput::value)
          .orElse(value);
    }
    return forcing
        .asked(SignalWrite.AnalogOutput.class, name())
        .map(asked -> domain().valueAt(asked.ratio()))
        .orElse(value);
  }

  private double ratio() {
    return Math.clamp(signal.ratio(), 0, 1);
  }

  /** The part of the range that the value is at, 0 to 1. */
  double valueRatio() {
    return Math.clamp(domain().ratioOf(value()), 0, 1);
  }

  /** Whether people may change the level now. */
  boolean settable() {
    return bank.input() || !programRuns;
  }

  /** Whether people may change the domain now. */
  boolean domainSettable() {
    return !programRuns;
  }

  /** Whether the user has set this input away from rest. */
  boolean forced() {
    return forcing.forced(name());
  }

  /** Its name outside of scripts. */
  String name() {
    return bank.name(index);
  }

  /**
   * Sets the level to what the user typed.
   *
   * @throws IllegalArgumentException with a sentence for people if it is no level
   */
  void set(String text) {
    set(AnalogText.parse(text, domain()));
  }

  /** Sets the level to a part of the range, 0 to 1. */
  void setRatio(double ratio) {
    set(domain().valueAt(ratio));
  }

  private void set(double value) {
    AnalogDomain domain = domain();
    double within = Math.clamp(value, domain.low(), domain.high());
    forcing.write(
        bank.input()
            ? new SignalWrite.AnalogInput(bank, index, within, domain)
            : new SignalWrite.AnalogOutput(index, Math.clamp(domain.ratioOf(within), 0, 1)));
  }

  /** Makes it a current or a voltage. */
  void setDomain(AnalogDomain domain) {
    if (domain != domain()) {
      forcing.write(new SignalWrite.Domain(bank, index, domain));
    }
  }
}
