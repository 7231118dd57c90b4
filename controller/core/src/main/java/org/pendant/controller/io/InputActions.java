package org.pendant.controller.io;

/**
 * Input actions: what high levels of inputs do by themselves; a bit is set where that is freedrive.
 *
 * @param standard of the standard digital inputs
 * @param configurable of the configurable digital inputs
 * @param tool of the tool's digital inputs
 * @param lowRegisters of the boolean input registers 0 to 63
 * @param highRegisters of the boolean input registers 64 to 127
 */
public record InputActions(
    int standard, int configurable, int tool, long lowRegisters, long highRegisters) {
  /** No input does anything. */
  public static final InputActions DEFAULT = new InputActions(0, 0, 0, 0, 0);

  /** The action of a digital input. */
  public InputAction of(Signal input) {
    return action((bits(input.bank()) >> input.index() & 1) != 0);
  }

  /**
   * The action of a boolean input register, 0 to 127.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public InputAction ofRegister(int address) {
    RegisterKind.BOOLEAN.check(address);
    long bits = address < Long.SIZE ? lowRegisters : highRegisters;
    return action((bits >> address & 1) != 0);
  }

  private static InputAction action(boolean freedrive) {
    return freedrive ? InputAction.FREEDRIVE : InputAction.DEFAULT;
  }

  private int bits(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> standard;
      case CONFIGURABLE_IN -> configurable;
      case TOOL_IN -> tool;
      case STANDARD_OUT, CONFIGURABLE_OUT, TOOL_OUT, FLAG -> 0;
    };
  }

  /** Whether an input that is high asks for freedrive. */
  public boolean freedriveDemanded(DigitalLevels levels, RegisterLevels inputs) {
    return ((standard & levels.standardIn())
                | (configurable & levels.configurableIn())
                | (tool & levels.toolIn()))
            != 0
        || ((lowRegisters & inputs.lowBits()) | (highRegisters & inputs.highBits())) != 0;
  }

  /** These actions with that of one digital input replaced. */
  InputActions with(Signal input, InputAction action) {
    int mask = 1 << input.index();
    int old = bits(input.bank());
    int now = action == InputAction.FREEDRIVE ? old | mask : old & ~mask;
    return new InputActions(
        input.bank() == SignalBank.STANDARD_IN ? now : standard,
        input.bank() == SignalBank.CONFIGURABLE_IN ? now : configurable,
        input.bank() == SignalBank.TOOL_IN ? now : tool,
        lowRegisters,
        highRegisters);
  }

  /** These actions with that of one boolean input register replaced. */
  InputActions withRegister(int address, InputAction action) {
    if (ofRegister(address) == action) {
      return this;
    }
    long mask = 1L << address;
    return address < Long.SIZE
        ? new InputActions(standard, configurable, tool, lowRegisters ^ mask, highRegisters)
        : new InputActions(standard, configurable, tool, lowRegisters, highRegisters ^ mask);
  }
}
