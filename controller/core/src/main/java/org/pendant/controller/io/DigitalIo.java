package org.pendant.controller.io;

import org.pendant.controller.wire.SignalLine;
import org.pendant.controller.wire.SignalOwner;

/**
 * The digital signals, owned by the frame loop. All are low at first; outputs and flags keep their
 * levels when a program ends.
 */
public final class DigitalIo implements SignalOwner {
  private DigitalLevels levels = DigitalLevels.ALL_LOW;

  /**
   * The level of signal {@code index} of {@code bank}.
   *
   * @throws IllegalArgumentException if the bank has no such signal
   */
  public boolean level(SignalBank bank, int index) {
    bank.check(index);
    return (levels.bits(bank) >> index & 1) != 0;
  }

  /**
   * Sets a signal, input or output.
   *
   * @throws IllegalArgumentException if the bank has no such signal
   */
  public void set(SignalBank bank, int index, boolean level) {
    bank.check(index);
    int mask = 1 << index;
    int old = levels.bits(bank);
    int now = level ? old | mask : old & ~mask;
    if (now != old) {
      levels = levels.with(bank, now);
    }
  }

  /**
   * Sets the input called {@code name}, such as {@code digital_in[0]}, {@code configurable_in[3]}
   * or {@code tool_in[1]}.
   *
   * @throws IllegalArgumentException if there is none; the message names those there are
   */
  public void setInput(String name, boolean level) {
    Signal signal = Signal.input(name);
    set(signal.bank(), signal.index(), level);
  }

  @Override
  public SignalLine line(String group, int index) {
    SignalBank bank = SignalBank.named(group);
    bank.check(index);
    return new SignalLine() {
      @Override
      public int value() {
        return level(bank, index) ? 1 : 0;
      }

      @Override
      public void set(int value) {
        DigitalIo.this.set(bank, index, value != 0);
      }
    };
  }

  /** All levels now; the same object until one changes. */
  public DigitalLevels levels() {
    return levels;
  }
}
