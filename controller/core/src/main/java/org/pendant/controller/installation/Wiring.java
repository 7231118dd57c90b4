package org.pendant.controller.installation;

import java.util.List;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;

/**
 * Wiring: what analog signals are made of, and how the tool connector is used.
 *
 * @param analogIn domains of the two standard analog inputs
 * @param analogOut domains of the two standard analog outputs
 * @param toolAnalogIn domains of the tool's two analog inputs
 * @param toolVoltage 0, 12 or 24 V
 * @param toolOutputMode of both output pins
 * @param toolPins of each output pin
 * @param toolCommunication of the serial line
 */
public record Wiring(
    List<AnalogDomain> analogIn,
    List<AnalogDomain> analogOut,
    List<AnalogDomain> toolAnalogIn,
    int toolVoltage,
    ToolOutputMode toolOutputMode,
    List<ToolPinMode> toolPins,
    ToolCommunication toolCommunication) {
  private static final List<AnalogDomain> CURRENTS =
      List.of(AnalogDomain.CURRENT, AnalogDomain.CURRENT);
  private static final List<AnalogDomain> VOLTAGES =
      List.of(AnalogDomain.VOLTAGE, AnalogDomain.VOLTAGE);

  /** As a new box has it. */
  public static final Wiring STANDARD =
      new Wiring(
          VOLTAGES,
          CURRENTS,
          VOLTAGES,
          0,
          ToolOutputMode.DIGITAL,
          List.of(ToolPinMode.SINKING, ToolPinMode.SINKING),
          ToolCommunication.STANDARD);

  public Wiring {
    analogIn = List.copyOf(analogIn);
    analogOut = List.copyOf(analogOut);
    toolAnalogIn = List.copyOf(toolAnalogIn);
    toolPins = List.copyOf(toolPins);
  }
}
