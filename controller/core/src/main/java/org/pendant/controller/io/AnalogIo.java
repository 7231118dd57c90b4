package org.pendant.controller.io;

import java.util.EnumMap;
import java.util.Map;

/**
 * The analog signals, owned by the frame loop. What is connected to an input has a voltage and a
 * current of its own: the domain only decides which of them the box reads. An output keeps its part
 * of the range when its domain changes.
 *
 * <p>A box that is new reads and measures as a fresh installation does: inputs in volts, outputs in
 * amperes, everything at the low end.
 */
public final class AnalogIo {
  private final Map<AnalogBank, Channel[]> channels = new EnumMap<>(AnalogBank.class);
  private AnalogLevels levels;
  private boolean stale;

  /** The wires of the tool's inputs carry something else: the box reads the low ends. */
  private boolean toolCutOff;

  /** What one signal is set to. */
  private static final class Channel {
    private AnalogDomain domain;
    private double currentA = AnalogDomain.CURRENT.low();
    private double voltageV = AnalogDomain.VOLTAGE.low();

    Channel(AnalogDomain domain) {
      this.domain = domain;
    }

    double value(AnalogDomain asked) {
      return asked == AnalogDomain.CURRENT ? currentA : voltageV;
    }
  }

  /** Inputs measure volts, outputs are currents; all are at their low end. */
  public AnalogIo() {
    for (AnalogBank bank : AnalogBank.values()) {
      AnalogDomain domain = bank.input() ? AnalogDomain.VOLTAGE : AnalogDomain.CURRENT;
      channels.put(bank, new Channel[] {new Channel(domain), new Channel(domain)});
    }
    levels = snapshot();
  }

  private Channel channel(AnalogBank bank, int index) {
    bank.check(index);
    return channels.get(bank)[index];
  }

  /**
   * What the box reads or puts out now, A or V as the domain says.
   *
   * @throws IllegalArgumentException if there is no such signal
   */
  public double value(AnalogBank bank, int index) {
    Channel channel = channel(bank, index);
    return toolCutOff && bank == AnalogBank.TOOL_IN
        ? channel.domain.low()
        : channel.value(channel.domain);
  }

  /**
   * Sets what is connected to an input. The box reads it while the input is in this domain.
   *
   * @param value A or V as the domain says, within its range
   * @throws IllegalArgumentException if there is no such input
   */
  void setInput(AnalogBank bank, int index, double value, AnalogDomain domain) {
    set(channel(bank, index), value, domain);
  }

  /**
   * Sets an output.
   *
   * @param ratio 0 for the low end of its range to 1 for the high one
   * @throws IllegalArgumentException if there is no such output
   */
  public void setOutput(int index, double ratio) {
    Channel channel = channel(AnalogBank.STANDARD_OUT, index);
    for (AnalogDomain domain : AnalogDomain.values()) {
      set(channel, domain.valueAt(ratio), domain);
    }
  }

  private void set(Channel channel, double value, AnalogDomain domain) {
    if (channel.value(domain) != value) {
      stale |= channel.domain == domain;
      switch (domain) {
        case CURRENT -> channel.currentA = value;
        case VOLTAGE -> channel.voltageV = value;
      }
    }
  }

  /**
   * Changes what a signal is made of.
   *
   * @throws IllegalArgumentException if there is no such signal
   */
  public void setDomain(AnalogBank bank, int index, AnalogDomain domain) {
    Channel channel = channel(bank, index);
    if (channel.domain != domain) {
      channel.domain = domain;
      stale = true;
    }
  }

  /** Disconnects the tool's inputs, or connects them again. */
  void cutOffTool(boolean cutOff) {
    stale |= cutOff != toolCutOff;
    toolCutOff = cutOff;
  }

  /** All signals now; the same object until one changes. */
  public AnalogLevels levels() {
    if (stale) {
      stale = false;
      levels = snapshot();
    }
    return levels;
  }

  private AnalogLevels snapshot() {
    return new AnalogLevels(
        signal(AnalogBank.STANDARD_IN, 0),
        signal(AnalogBank.STANDARD_IN, 1),
        signal(AnalogBank.STANDARD_OUT, 0),
        signal(AnalogBank.STANDARD_OUT, 1),
        signal(AnalogBank.TOOL_IN, 0),
        signal(AnalogBank.TOOL_IN, 1));
  }

  private AnalogSignal signal(AnalogBank bank, int index) {
    return new AnalogSignal(value(bank, index), channel(bank, index).domain);
  }
}
