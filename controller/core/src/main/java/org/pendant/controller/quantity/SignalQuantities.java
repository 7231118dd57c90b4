package org.pendant.controller.quantity;

import static org.pendant.controller.quantity.PhysicalUnit.AMPERE;
import static org.pendant.controller.quantity.PhysicalUnit.AMPERE_OR_VOLT;
import static org.pendant.controller.quantity.PhysicalUnit.LEVEL;
import static org.pendant.controller.quantity.PhysicalUnit.NONE;
import static org.pendant.controller.quantity.PhysicalUnit.VOLT;
import static org.pendant.controller.quantity.ScalarType.BOOL;
import static org.pendant.controller.quantity.ScalarType.DOUBLE;
import static org.pendant.controller.quantity.ScalarType.INT32;
import static org.pendant.controller.quantity.ScalarType.UINT32;
import static org.pendant.controller.quantity.ScalarType.UINT64;
import static org.pendant.controller.quantity.ScalarType.UINT8;

import java.util.List;
import java.util.Locale;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.state.RobotBits;

/** Quantities of inputs, outputs, flags and registers. */
final class SignalQuantities {
  /** The first boolean register with an RTDE field of its own; those below come by 32. */
  private static final int FIRST_SINGLE = 64;

  private SignalQuantities() {}

  static void declareIn(QuantityList list) {
    list.group("Signals");
    for (SignalBank bank : SignalBank.values()) {
      addDigital(list, bank);
    }
    for (AnalogBank bank : AnalogBank.values()) {
      addAnalog(list, bank);
    }
    list.group("Signals/Tool");
    addTool(list);
    list.group("Signals/Encoders");
    list.whole("encoder_0", "Encoder 0", INT32, s -> s.encoders().first()).rtde("encoder0_raw");
    list.whole("encoder_1", "Encoder 1", INT32, s -> s.encoders().second()).rtde("encoder1_raw");
    list.group("Signals/EUROMAP 67");
    addAbsent(list);
    list.group("Signals/Packed bits");
    addPacked(list);
    list.group("Registers");
    for (RegisterDirection direction : RegisterDirection.values()) {
      addRegisters(list, direction);
    }
  }

  private static void addDigital(QuantityList list, SignalBank bank) {
    String name = bank.text();
    list.add(
        name,
        titleOf(bank),
        BOOL,
        QuantityList.numbered(name, bank.size(), i -> name + "[" + i + "]", LEVEL),
        new Getter.OfEach(bank.size(), (s, index) -> s.io().bits(bank) >> index & 1));
  }

  private static void addAnalog(QuantityList list, AnalogBank bank) {
    String name = bank.text();
    list.add(
            name,
            titleOf(bank),
            DOUBLE,
            QuantityList.numbered(name, AnalogBank.SIZE, bank::name, AMPERE_OR_VOLT),
            new Getter.OfEach(
                AnalogBank.SIZE, (s, index) -> s.signals().analog().signal(bank, index).value()))
        .rtdeEach(i -> rtde(bank) + i);
    list.add(
            name + "_domain",
            titleOf(bank) + ", domains",
            UINT8,
            QuantityList.numbered(
                name + "_domain", AnalogBank.SIZE, i -> "Domain of " + bank.name(i), NONE),
            new Getter.OfEach(
                AnalogBank.SIZE,
                (s, index) -> s.signals().analog().signal(bank, index).domain().number()))
        .explained("0 for current, 1 for voltage");
  }

  private static void addTool(QuantityList list) {
    list.scalar("tool_voltage", "Tool voltage", INT32, VOLT, s -> s.signals().tool().voltageV())
        .rtde("tool_output_voltage");
    list.whole(
            "tool_output_mode",
            "Output mode",
            UINT8,
            s -> s.signals().tool().outputMode() == ToolOutputMode.DUAL_PIN_POWER ? 1 : 0)
        .explained("1 while two pins supply together")
        .rtde("tool_output_mode");
    list.add(
            "tool_pin_mode",
            "Output modes",
            UINT8,
            QuantityList.numbered("tool_pin_mode", 2, i -> "Output " + i, NONE),
            new Getter.OfEach(2, (s, index) -> s.signals().tool().pin(index).number()))
        .rtdeEach(i -> "tool_digital_output" + i + "_mode");
  }

  private static void addPacked(QuantityList list) {
    for (SignalBank bank : SignalBank.values()) {
      list.whole(
          bank.text() + "_bits",
          titleOf(bank),
          UINT64,
          s -> Integer.toUnsignedLong(s.io().bits(bank)));
      switch (bank) {
        case CONFIGURABLE_IN -> list.rtde("actual_configurable_digital_input_bits");
        case CONFIGURABLE_OUT -> list.rtde("actual_configurable_digital_output_bits");
        case STANDARD_IN, STANDARD_OUT, TOOL_IN, TOOL_OUT, FLAG -> {}
      }
    }
    list.whole(
            "digital_input_bits",
            "All digital inputs",
            UINT64,
            s -> RobotBits.digitalInputs(s.io()))
        .rtde("actual_digital_input_bits");
    list.whole(
            "digital_output_bits",
            "All digital outputs",
            UINT64,
            s -> RobotBits.digitalOutputs(s.io()))
        .rtde("actual_digital_output_bits");
    list.whole(
            "analog_domain_bits",
            "Analog domains",
            UINT32,
            s -> s.signals().analog().standardDomainBits())
        .rtde("analog_io_types");
    list.whole(
            "tool_analog_domain_bits",
            "Analog domains of the tool",
            UINT32,
            s -> s.signals().analog().toolDomainBits())
        .rtde("tool_analog_input_types");
  }

  /** What a connector for an injection moulding machine would tell; there is none. */
  private static void addAbsent(QuantityList list) {
    list.whole("euromap67_inputs", "Inputs", UINT32, s -> 0).rtde("euromap67_input_bits");
    list.whole("euromap67_outputs", "Outputs", UINT32, s -> 0).rtde("euromap67_output_bits");
    list.number("euromap67_voltage", "Voltage", VOLT, s -> 0).rtde("euromap67_24V_voltage");
    list.number("euromap67_current", "Current", AMPERE, s -> 0).rtde("euromap67_24V_current");
  }

  private static void addRegisters(QuantityList list, RegisterDirection direction) {
    String side = direction.text();
    list.add(
            side + "_register_bits",
            capital(side) + "s, packed",
            UINT32,
            List.of(
                new Component(side + "_register_bits_0", side + " registers 0 to 31", NONE),
                new Component(side + "_register_bits_1", side + " registers 32 to 63", NONE)),
            new Getter.OfEach(
                2,
                (s, index) ->
                    Integer.toUnsignedLong(
                        (int)
                            (s.signals().registers(direction).lowBits()
                                >>> (Integer.SIZE * index)))))
        .rtdeEach(i -> side + "_bit_registers" + (i == 0 ? "0_to_31" : "32_to_63"));
    for (RegisterKind kind : RegisterKind.values()) {
      String name = side + "_" + kind.text() + "_register";
      String field =
          switch (kind) {
            case BOOLEAN -> side + "_bit_register_";
            case INTEGER -> side + "_int_register_";
            case FLOAT -> side + "_double_register_";
          };
      list.add(
              name,
              capital(side) + "s, " + kind.text(),
              typeOf(kind),
              QuantityList.numbered(
                  name,
                  kind.size(),
                  i -> direction.name(kind, i),
                  kind == RegisterKind.BOOLEAN ? LEVEL : NONE),
              new Getter.OfRegisters(direction, kind))
          .rtdeEach(i -> kind == RegisterKind.BOOLEAN && i < FIRST_SINGLE ? "" : field + i);
    }
  }

  private static ScalarType typeOf(RegisterKind kind) {
    return switch (kind) {
      case BOOLEAN -> BOOL;
      case INTEGER -> INT32;
      case FLOAT -> DOUBLE;
    };
  }

  private static String capital(String word) {
    return word.substring(0, 1).toUpperCase(Locale.ROOT) + word.substring(1);
  }

  private static String rtde(AnalogBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "standard_analog_input";
      case STANDARD_OUT -> "standard_analog_output";
      case TOOL_IN -> "tool_analog_input";
    };
  }

  private static String titleOf(AnalogBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "Analog inputs";
      case STANDARD_OUT -> "Analog outputs";
      case TOOL_IN -> "Analog tool inputs";
    };
  }

  private static String titleOf(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "Digital inputs";
      case STANDARD_OUT -> "Digital outputs";
      case CONFIGURABLE_IN -> "Configurable inputs";
      case CONFIGURABLE_OUT -> "Configurable outputs";
      case TOOL_IN -> "Tool inputs";
      case TOOL_OUT -> "Tool outputs";
      case FLAG -> "Flags";
    };
  }
}
