package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.pendant.controller.box.Published;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.RegisterKind;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;

/**
 * Input fields: all that RTDE clients may write. A mask selects, in the package that it comes in,
 * which outputs the other fields of the package set; without its mask a field sets nothing. Who
 * takes a mask takes the mask only, not what it could select.
 */
public final class InputFields {
  private static final int BITS = 32;

  /** Boolean registers below are written in two groups, those from here on one by one. */
  private static final int FIRST_SINGLE_BIT = 64;

  private static final Map<String, InputField> FIELDS = fields();

  private InputFields() {}

  /** The field called {@code name}. */
  public static Optional<InputField> of(String name) {
    return Optional.ofNullable(FIELDS.get(name));
  }

  /** All fields. */
  public static List<InputField> all() {
    return List.copyOf(FIELDS.values());
  }

  private static Map<String, InputField> fields() {
    Map<String, InputField> fields = new LinkedHashMap<>();
    addSpeedSlider(fields);
    addOutputs(fields, "standard_digital_output", SignalBank.STANDARD_OUT);
    addOutputs(fields, "configurable_digital_output", SignalBank.CONFIGURABLE_OUT);
    addOutputs(fields, "tool_digital_output", SignalBank.TOOL_OUT);
    addAnalogOutputs(fields);
    addRegisters(fields);
    add(
        fields,
        Published.EXTERNAL_FORCE_TORQUE,
        FieldType.VECTOR6D,
        List.of(Published.EXTERNAL_FORCE_TORQUE),
        (values, into) -> {
          double[] wrench6 = new double[6];
          for (int i = 0; i < wrench6.length; i++) {
            wrench6[i] = values.getDouble();
          }
          into.setExternalWrench(wrench6);
        });
    return Collections.unmodifiableMap(fields);
  }

  private static void add(
      Map<String, InputField> fields,
      String name,
      FieldType type,
      List<String> claims,
      InputField.Decoder decoder) {
    fields.put(name, new InputField(name, type, claims, decoder));
  }

  private static void addSpeedSlider(Map<String, InputField> fields) {
    add(
        fields,
        "speed_slider_mask",
        FieldType.UINT32,
        List.of("speed_slider_mask"),
        (values, into) -> into.setSpeedMask(Integer.toUnsignedLong(values.getInt())));
    add(
        fields,
        "speed_slider_fraction",
        FieldType.DOUBLE,
        List.of(InputOwners.SPEED_SLIDER),
        (values, into) -> into.setSpeedFraction(values.getDouble()));
  }

  private static void addOutputs(Map<String, InputField> fields, String name, SignalBank bank) {
    String mask = name + "_mask";
    add(
        fields,
        mask,
        FieldType.UINT8,
        List.of(mask),
        (values, into) -> into.outputs(bank).setMask(uint8(values)));
    add(
        fields,
        name,
        FieldType.UINT8,
        IntStream.range(0, bank.size()).mapToObj(i -> new Signal(bank, i).toString()).toList(),
        (values, into) -> into.outputs(bank).setLevels(uint8(values)));
  }

  private static void addAnalogOutputs(Map<String, InputField> fields) {
    String mask = "standard_analog_output_mask";
    String types = "standard_analog_output_type";
    add(
        fields,
        mask,
        FieldType.UINT8,
        List.of(mask),
        (values, into) -> into.setAnalogMask(uint8(values)));
    add(
        fields,
        types,
        FieldType.UINT8,
        List.of(types),
        (values, into) -> into.setAnalogTypes(uint8(values)));
    for (int i = 0; i < AnalogBank.SIZE; i++) {
      int index = i;
      add(
          fields,
          "standard_analog_output_" + i,
          FieldType.DOUBLE,
          List.of(AnalogBank.STANDARD_OUT.name(i)),
          (values, into) -> into.setAnalogRatio(index, values.getDouble()));
    }
  }

  private static void addRegisters(Map<String, InputField> fields) {
    for (int first = 0; first < FIRST_SINGLE_BIT; first += BITS) {
      int from = first;
      add(
          fields,
          "input_bit_registers" + first + "_to_" + (first + BITS - 1),
          FieldType.UINT32,
          IntStream.range(first, first + BITS)
              .mapToObj(i -> claim(RegisterKind.BOOLEAN, i))
              .toList(),
          (values, into) -> writeBits(from, values.getInt(), into));
    }
    for (int i = FIRST_SINGLE_BIT; i < RegisterKind.BOOLEAN.size(); i++) {
      int address = i;
      add(
          fields,
          "input_bit_register_" + i,
          FieldType.BOOL,
          List.of(claim(RegisterKind.BOOLEAN, i)),
          (values, into) -> writeBit(address, values.get() != 0, into));
    }
    for (int i = 0; i < RegisterKind.INTEGER.size(); i++) {
      int address = i;
      add(
          fields,
          "input_int_register_" + i,
          FieldType.INT32,
          List.of(claim(RegisterKind.INTEGER, i)),
          (values, into) ->
              into.write(
                  new SignalWrite.IntegerRegister(
                      RegisterDirection.INPUT, address, values.getInt())));
    }
    for (int i = 0; i < RegisterKind.FLOAT.size(); i++) {
      int address = i;
      add(
          fields,
          "input_double_register_" + i,
          FieldType.DOUBLE,
          List.of(claim(RegisterKind.FLOAT, i)),
          (values, into) ->
              into.write(
                  new SignalWrite.FloatRegister(
                      RegisterDirection.INPUT, address, values.getDouble())));
    }
  }

  private static String claim(RegisterKind kind, int address) {
    return RegisterDirection.INPUT.name(kind, address);
  }

  private static void writeBits(int first, int bits, InputGathering into) {
    for (int i = 0; i < BITS; i++) {
      writeBit(first + i, (bits >> i & 1) != 0, into);
    }
  }

  private static void writeBit(int address, boolean value, InputGathering into) {
    into.write(new SignalWrite.BooleanRegister(RegisterDirection.INPUT, address, value));
  }

  private static int uint8(ByteBuffer values) {
    return Byte.toUnsignedInt(values.get());
  }
}
