package org.pendant.controller.io;

/**
 * How the connector at the tool flange is set up (manual 18.51 to 18.53).
 *
 * @param voltageV what it supplies: 0, 12 or 24 V
 * @param outputMode what the two output pins are for
 * @param pin0 how output 0 drives what hangs on it
 * @param pin1 how output 1 drives what hangs on it
 */
public record ToolConnector(
    int voltageV, ToolOutputMode outputMode, ToolPinMode pin0, ToolPinMode pin1) {
  /** How a new box sets it up: no supply, two sinking outputs. */
  public static final ToolConnector STANDARD =
      new ToolConnector(0, ToolOutputMode.DIGITAL, ToolPinMode.SINKING, ToolPinMode.SINKING);

  /**
   * Checks the voltage.
   *
   * @throws IllegalArgumentException if it is none of 0, 12 and 24
   */
  public ToolConnector {
    if (!isVoltage(voltageV)) {
      throw new IllegalArgumentException(
          "tool voltage is " + voltageV + " V, must be 0, 12 or 24 V");
    }
  }

  /** Whether the connector can supply so many volts. */
  public static boolean isVoltage(int voltageV) {
    return voltageV == 0 || voltageV == 12 || voltageV == 24;
  }

  /** How an output pin, 0 or 1, drives what hangs on it. */
  public ToolPinMode pin(int index) {
    SignalBank.TOOL_OUT.check(index);
    return index == 0 ? pin0 : pin1;
  }

  ToolConnector withVoltage(int volts) {
    return new ToolConnector(volts, outputMode, pin0, pin1);
  }

  ToolConnector withOutputMode(ToolOutputMode mode) {
    return new ToolConnector(voltageV, mode, pin0, pin1);
  }

  ToolConnector withPin(int index, ToolPinMode mode) {
    SignalBank.TOOL_OUT.check(index);
    return new ToolConnector(
        voltageV, outputMode, index == 0 ? mode : pin0, index == 1 ? mode : pin1);
  }
}
