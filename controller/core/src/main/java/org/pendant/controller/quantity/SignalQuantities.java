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
    list.group("signals");
    for (SignalBank bank : SignalBank.values()) {
      addDigital(list, bank);
    }
    for (AnalogBank bank : AnalogBank.values()) {
      addAnalog(list, bank);
    }
    list.group("signals", "tool");
    addTool(list);
    list.group("signals", "encoders");
    list.whole("encoder_0", "encoder0", INT32, s -> s.encoders().first()).rtde("encoder0_raw");
    list.whole("encoder_1", "encoder1", INT32, s -> s.encoders().second()).rtde("encoder1_raw");
    list.group("signals", "euromap67");
    addAbsent(list);
    list.group("signals", "packedBits");
    addPacked(list);
    list.group("registers");
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
        QuantityList.numbered(
            name, bank.size(), i -> QuantityTitle.named(name + "[" + i + "]"), LEVEL),
        new Getter.OfEach(bank.size(), (s, index) -> s.io().bits(bank) >> index & 1));
  }

  private static void addAnalog(QuantityList list, AnalogBank bank) {
    String name = bank.text();
    list.add(
            name,
            titleOf(bank),
            DOUBLE,
            QuantityList.numbered(
                name, AnalogBank.SIZE, i -> QuantityTitle.named(bank.name(i)), AMPERE_OR_VOLT),
            new Getter.OfEach(
                AnalogBank.SIZE, (s, index) -> s.signals().analog().signal(bank, index).value()))
        .rtdeEach(i -> rtde(bank) + i);
    list.add(
            name + "_domain",
            domainsOf(bank),
            UINT8,
            QuantityList.numbered(
                name + "_domain",
                AnalogBank.SIZE,
                i -> QuantityTitle.of("domainOf", bank.name(i)),
                NONE),
            new Getter.OfEach(
                AnalogBank.SIZE,
                (s, index) -> s.signals().analog().signal(bank, index).domain().number()))
        .explained("domainExplained");
  }

  private static void addTool(QuantityList list) {
    list.scalar("tool_voltage", "toolVoltage", INT32, VOLT, s -> s.signals().tool().voltageV())
        .rtde("tool_output_voltage");
    list.whole(
            "tool_output_mode",
            "outputMode",
            UINT8,
            s -> s.signals().tool().outputMode() == ToolOutputMode.DUAL_PIN_POWER ? 1 : 0)
        .explained("outputModeExplained")
        .rtde("tool_output_mode");
    list.add(
            "tool_pin_mode",
            "outputModes",
            UINT8,
            QuantityList.numbered("tool_pin_mode", 2, i -> QuantityTitle.of("output", i), NONE),
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
            "digital_input_bits", "allDigitalInputs", UINT64, s -> RobotBits.digitalInputs(s.io()))
        .rtde("actual_digital_input_bits");
    list.whole(
            "digital_output_bits",
            "allDigitalOutputs",
            UINT64,
            s -> RobotBits.digitalOutputs(s.io()))
        .rtde("actual_digital_output_bits");
    list.whole(
            "analog_domain_bits",
            "analogDomains",
            UINT32,
            s -> s.signals().analog().standardDomainBits())
        .rtde("analog_io_types");
    list.whole(
            "tool_analog_domain_bits",
            "analogDomainsOfTheTool",
            UINT32,
            s -> s.signals().analog().toolDomainBits())
        .rtde("tool_analog_input_types");
  }

  /** What a connector for an injection moulding machine would tell; there is none. */
  private static void addAbsent(QuantityList list) {
    list.whole("euromap67_inputs", "inputs", UINT32, s -> 0).rtde("euromap67_input_bits");
    list.whole("euromap67_outputs", "outputs", UINT32, s -> 0).rtde("euromap67_output_bits");
    list.number("euromap67_voltage", "voltage", VOLT, s -> 0).rtde("euromap67_24V_voltage");
    list.number("euromap67_current", "current", AMPERE, s -> 0).rtde("euromap67_24V_current");
  }

  private static void addRegisters(QuantityList list, RegisterDirection direction) {
    String side = direction.text();
    boolean input = direction == RegisterDirection.INPUT;
    list.add(
            side + "_register_bits",
            input ? "inputsPacked" : "outputsPacked",
            UINT32,
            List.of(
                new Component(
                    side + "_register_bits_0",
                    QuantityTitle.of(input ? "inputRegistersLow" : "outputRegistersLow"),
                    NONE),
                new Component(
                    side + "_register_bits_1",
                    QuantityTitle.of(input ? "inputRegistersHigh" : "outputRegistersHigh"),
                    NONE)),
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
              titleOf(input, kind),
              typeOf(kind),
              QuantityList.numbered(
                  name,
                  kind.size(),
                  i -> QuantityTitle.named(direction.name(kind, i)),
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

  private static String titleOf(boolean input, RegisterKind kind) {
    return switch (kind) {
      case BOOLEAN -> input ? "inputsBoolean" : "outputsBoolean";
      case INTEGER -> input ? "inputsInteger" : "outputsInteger";
      case FLOAT -> input ? "inputsFloat" : "outputsFloat";
    };
  }

  private static String domainsOf(AnalogBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "analogInputsDomains";
      case STANDARD_OUT -> "analogOutputsDomains";
      case TOOL_IN -> "analogToolInputsDomains";
    };
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
      case STANDARD_IN -> "analogInputs";
      case STANDARD_OUT -> "analogOutputs";
      case TOOL_IN -> "analogToolInputs";
    };
  }

  private static String titleOf(SignalBank bank) {
    return switch (bank) {
      case STANDARD_IN -> "digitalInputs";
      case STANDARD_OUT -> "digitalOutputs";
      case CONFIGURABLE_IN -> "configurableInputs";
      case CONFIGURABLE_OUT -> "configurableOutputs";
      case TOOL_IN -> "toolInputs";
      case TOOL_OUT -> "toolOutputs";
      case FLAG -> "flags";
    };
  }
}
