package org.pendant.controller.rtde;

import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.RobotBits;

/** Fields about inputs and outputs of control box and tool. */
final class SignalFields {
  private SignalFields() {}

  static void addTo(FieldList list) {
    addBox(list);
    addTool(list);
  }

  private static void addBox(FieldList list) {
    list.uint64("actual_digital_input_bits", state -> RobotBits.digitalInputs(state.io()));
    list.uint64("actual_digital_output_bits", state -> RobotBits.digitalOutputs(state.io()));
    list.uint64("actual_configurable_digital_input_bits", state -> state.io().configurableIn());
    list.uint64("actual_configurable_digital_output_bits", state -> state.io().configurableOut());
    list.uint32("analog_io_types", state -> state.signals().analog().standardDomainBits());
    analog(list, "standard_analog_input", AnalogBank.STANDARD_IN);
    analog(list, "standard_analog_output", AnalogBank.STANDARD_OUT);
    // there is no connector for an injection moulding machine
    list.uint32("euromap67_input_bits", state -> 0);
    list.uint32("euromap67_output_bits", state -> 0);
    list.number("euromap67_24V_voltage", state -> 0);
    list.number("euromap67_24V_current", state -> 0);
    list.int32("encoder0_raw", state -> state.encoders().first());
    list.int32("encoder1_raw", state -> state.encoders().second());
  }

  private static void addTool(FieldList list) {
    list.uint32("tool_mode", state -> RobotBits.toolMode(state).code());
    list.uint32("tool_analog_input_types", state -> state.signals().analog().toolDomainBits());
    analog(list, "tool_analog_input", AnalogBank.TOOL_IN);
    list.int32("tool_output_voltage", state -> state.signals().tool().voltageV());
    list.number("tool_output_current", state -> state.readings().toolCurrentA());
    list.number("tool_temperature", state -> state.readings().toolTemperatureC());
    list.uint8("tool_output_mode", SignalFields::outputMode);
    list.uint8("tool_digital_output0_mode", state -> state.signals().tool().pin0().number());
    list.uint8("tool_digital_output1_mode", state -> state.signals().tool().pin1().number());
  }

  private static int outputMode(ControllerState state) {
    return switch (state.signals().tool().outputMode()) {
      case DIGITAL -> 0;
      case DUAL_PIN_POWER -> 1;
    };
  }

  /** Both signals of a pair, in A or V as their domains say. */
  private static void analog(FieldList list, String name, AnalogBank bank) {
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      int index = i;
      list.number(name + i, state -> state.signals().analog().signal(bank, index).value());
    }
  }
}
