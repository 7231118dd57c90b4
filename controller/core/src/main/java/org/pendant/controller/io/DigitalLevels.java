package org.pendant.controller.io;

/**
 * The levels of all digital signals at one moment, one bit a signal, signal 0 lowest.
 *
 * @param standardIn 8 bits
 * @param standardOut 8 bits
 * @param configurableIn 8 bits
 * @param configurableOut 8 bits
 * @param toolIn 2 bits
 * @param toolOut 2 bits
 * @param flags 32 bits
 */
public record DigitalLevels(
    int standardIn,
    int standardOut,
    int configurableIn,
    int configurableOut,
    int toolIn,
    int toolOut,
    int flags) {
  /** Every signal low. */
  public static final DigitalLevels ALL_LOW = new DigitalLevels(0, 0, 0, 0, 0, 0, 0);

  /** The bits of one group. */
  public int bits(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> standardIn;
      case STANDARD_OUT -> standardOut;
      case CONFIGURABLE_IN -> configurableIn;
      case CONFIGURABLE_OUT -> configurableOut;
      case TOOL_IN -> toolIn;
      case TOOL_OUT -> toolOut;
      case FLAG -> flags;
    };
  }

  /** These levels with the bits of one group replaced. */
  DigitalLevels with(SignalBank bank, int bits) {
    return new DigitalLevels(
        bank == SignalBank.STANDARD_IN ? bits : standardIn,
        bank == SignalBank.STANDARD_OUT ? bits : standardOut,
        bank == SignalBank.CONFIGURABLE_IN ? bits : configurableIn,
        bank == SignalBank.CONFIGURABLE_OUT ? bits : configurableOut,
        bank == SignalBank.TOOL_IN ? bits : toolIn,
        bank == SignalBank.TOOL_OUT ? bits : toolOut,
        bank == SignalBank.FLAG ? bits : flags);
  }

  /** The level of one signal. */
  public boolean level(Signal signal) {
    return (bits(signal.bank()) >> signal.index() & 1) != 0;
  }
}
