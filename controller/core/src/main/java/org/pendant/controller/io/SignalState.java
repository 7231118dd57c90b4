package org.pendant.controller.io;

/**
 * State of all signals but the digital ones at one moment. The same object, and the same parts,
 * until something changes.
 *
 * @param analog analog inputs and outputs
 * @param tool how the connector at the tool flange is set up
 * @param inputs general-purpose registers that the world outside writes
 * @param outputs general-purpose registers that programs write
 * @param ports memory shared with Modbus clients
 * @param actions what high levels of inputs do by themselves
 */
public record SignalState(
    AnalogLevels analog,
    ToolConnector tool,
    RegisterLevels inputs,
    RegisterLevels outputs,
    PortLevels ports,
    InputActions actions) {
  /** The registers of one direction. */
  public RegisterLevels registers(RegisterDirection direction) {
    return switch (direction) {
      case INPUT -> inputs;
      case OUTPUT -> outputs;
    };
  }
}
