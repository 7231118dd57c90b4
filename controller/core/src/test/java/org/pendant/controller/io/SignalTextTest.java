package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class SignalTextTest {
  private static void reads(SignalWrite expected, String name, String value) {
    assertEquals(List.of(expected), SignalText.input(name, value));
  }

  private static void refuses(String message, String name, String value) {
    assertEquals(
        message,
        assertThrows(IllegalArgumentException.class, () -> SignalText.input(name, value))
            .getMessage());
  }

  @Test
  void digitalInputsTakeLevels() {
    reads(
        new SignalWrite.Digital(new Signal(SignalBank.CONFIGURABLE_IN, 3), true),
        "configurable_in[3]",
        "true");
    reads(new SignalWrite.Digital(new Signal(SignalBank.TOOL_IN, 0), false), "tool_in[0]", "0");
    refuses("level is perhaps, must be true or false", "digital_in[0]", "perhaps");
    refuses("digital_in: index is 8, must be 0 to 7", "digital_in[8]", "true");
  }

  @Test
  void analogInputsTakeTheDomainOfTheUnit() {
    assertEquals(
        List.of(
            new SignalWrite.Domain(AnalogBank.STANDARD_IN, 1, AnalogDomain.VOLTAGE),
            new SignalWrite.AnalogInput(AnalogBank.STANDARD_IN, 1, 7.5, AnalogDomain.VOLTAGE)),
        SignalText.input("analog_in[1]", "7.5V"));
    assertEquals(
        List.of(
            new SignalWrite.Domain(AnalogBank.TOOL_IN, 0, AnalogDomain.CURRENT),
            new SignalWrite.AnalogInput(AnalogBank.TOOL_IN, 0, 0.012, AnalogDomain.CURRENT)),
        SignalText.input("tool_analog_in[0]", "12 mA"));
    assertEquals(
        SignalText.input("analog_in[0]", "20mA"), SignalText.input("analog_in[0]", "0.02A"));
    refuses("analog_in[0] is 5, must have a unit, such as 5V or 12mA", "analog_in[0]", "5");
    refuses("analog_in[0] is -1.0 V, must be 0.0 to 10.0 V", "analog_in[0]", "-1V");
    refuses("analog_in[0] is 1.2.3, must be a number", "analog_in[0]", "1.2.3V");
    refuses("analog_in: index is 2, must be 0 to 1", "analog_in[2]", "1V");
  }

  @Test
  void registersTakeNumbers() {
    reads(
        new SignalWrite.BooleanRegister(RegisterDirection.INPUT, 64, true),
        "input_boolean_register[64]",
        "1");
    reads(
        new SignalWrite.IntegerRegister(RegisterDirection.INPUT, 0, -7),
        "input_integer_register[0]",
        "-7");
    reads(
        new SignalWrite.FloatRegister(RegisterDirection.INPUT, 47, 0.25),
        "input_float_register[47]",
        "0.25");
    reads(new SignalWrite.PortRegister(128, (short) -1), "port_register[128]", "65535");
    reads(new SignalWrite.PortBit(200, true), "port_bit[200]", "true");
    refuses(
        "input_integer_register[0] is 1.5, must be a whole number from -2147483648 to 2147483647",
        "input_integer_register[0]",
        "1.5");
    refuses("input_float_register[0] is NaN, must be a number", "input_float_register[0]", "NaN");
    refuses("float register: address is 48, must be 0 to 47", "input_float_register[48]", "1");
  }

  @Test
  void anUnknownNameIsRefusedWithThoseThereAre() {
    for (String name : List.of("digital_out[0]", "analog_out[0]", "digital_in", "x[0]", "")) {
      UnknownSignal unknown =
          assertThrows(UnknownSignal.class, () -> SignalText.input(name, "true"));
      assertTrue(
          unknown
              .getMessage()
              .startsWith(
                  "input is '" + name + "', must be one of digital_in[0] to [7], configurable_in"),
          unknown.getMessage());
    }
  }
}
