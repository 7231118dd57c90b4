package org.pendant.controller.io;

import org.pendant.controller.external.ToolCommunication;

/**
 * Tool connector: how the connector at the tool flange is set up (manual 18.50 to 18.53).
 *
 * @param voltageV what it supplies: 0, 12 or 24 V
 * @param outputMode what the two output pins are for
 * @param pin0 how output 0 drives what hangs on it
 * @param pin1 how output 1 drives what hangs on it
 * @param communication how its serial line is set up
 */
public record ToolConnector(
    int voltageV,
    ToolOutputMode outputMode,
    ToolPinMode pin0,
    ToolPinMode pin1,
    ToolCommunication communication) {
  /** How a new box sets it up: no supply, two sinking outputs, no serial line. */
  public static final ToolConnector STANDARD =
      new ToolConnector(
          0,
          ToolOutputMode.DIGITAL,
          ToolPinMode.SINKING,
          ToolPinMode.SINKING,
          ToolCommunication.STANDARD);

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

  /** What a tool takes that is only supplied, ohm. */
  private static final double SUPPLIED_OHM = 960;

  /** What is connected to an output that is high, ohm. */
  private static final double SWITCHED_OHM = 480;

  /** What the electronics in the tool flange take, A. */
  private static final double ELECTRONICS_A = 0.08;

  /**
   * The current that the flange and its tool take, A.
   *
   * @param outputs levels of the tool's outputs, bits 0 and 1
   */
  double currentA(int outputs) {
    return ELECTRONICS_A + loadA(outputs);
  }

  /**
   * The current that a tool takes which the connector supplies: an invented one, whose outputs
   * switch loads. Two pins that supply together are both on.
   *
   * @param outputs levels of the tool's outputs, bits 0 and 1
   */
  private double loadA(int outputs) {
    int on = outputMode == ToolOutputMode.DUAL_PIN_POWER ? 2 : Integer.bitCount(outputs & 3);
    return voltageV / SUPPLIED_OHM + on * (voltageV / SWITCHED_OHM);
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
    return new ToolConnector(volts, outputMode, pin0, pin1, communication);
  }

  ToolConnector withOutputMode(ToolOutputMode mode) {
    return new ToolConnector(voltageV, mode, pin0, pin1, communication);
  }

  ToolConnector withPin(int index, ToolPinMode mode) {
    SignalBank.TOOL_OUT.check(index);
    return new ToolConnector(
        voltageV, outputMode, index == 0 ? mode : pin0, index == 1 ? mode : pin1, communication);
  }

  ToolConnector withCommunication(ToolCommunication wanted) {
    return new ToolConnector(voltageV, outputMode, pin0, pin1, wanted);
  }
}
