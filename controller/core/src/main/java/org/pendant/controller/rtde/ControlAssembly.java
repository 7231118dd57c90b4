package org.pendant.controller.rtde;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.pendant.controller.eip.AssemblyData;

/**
 * Control assembly: the built-in one of EtherNet/IP from scanner to robot, instance 112: speed
 * slider, outputs, and input registers. It has the fields of an RTDE package, with floats where
 * that has doubles, and so they are taken, checked and owned in the same way.
 */
public final class ControlAssembly {
  /** Its size. */
  public static final int BYTES = 224;

  /** Registers of each kind in one of the two groups. */
  private static final int GROUP = 12;

  /** Where the registers begin, behind the outputs. */
  private static final int REGISTERS = 24;

  /** What it writes. */
  public static final InputRecipe RECIPE = new InputRecipe(fields());

  private ControlAssembly() {}

  private static List<InputField> fields() {
    List<String> names =
        new ArrayList<>(
            List.of(
                "speed_slider_mask",
                "speed_slider_fraction",
                "standard_digital_output_mask",
                "configurable_digital_output_mask",
                "standard_digital_output",
                "configurable_digital_output",
                "standard_analog_output_mask",
                "standard_analog_output_type",
                "tool_digital_output_mask",
                "tool_digital_output",
                "standard_analog_output_0",
                "standard_analog_output_1"));
    addGroup(names, "input_bit_registers0_to_31", 0);
    addGroup(names, "input_bit_registers32_to_63", GROUP);
    return names.stream().map(name -> InputFields.of(name).orElseThrow()).toList();
  }

  private static void addGroup(List<String> names, String bits, int first) {
    names.add(bits);
    for (int i = first; i < first + GROUP; i++) {
      names.add("input_int_register_" + i);
    }
    for (int i = first; i < first + GROUP; i++) {
      names.add("input_double_register_" + i);
    }
  }

  /**
   * The bytes of a scanner that writes no outputs; floats are 0.
   *
   * @param bits boolean input registers 0 to 63, the lowest in bit 0
   * @param words integer input registers 0 to 23
   * @param speedFraction where the speed slider goes, 0 to 1; empty for a mask that is not set
   */
  public static AssemblyData encode(long bits, List<Integer> words, OptionalDouble speedFraction) {
    ByteBuffer out = ByteBuffer.allocate(BYTES).order(ByteOrder.LITTLE_ENDIAN);
    out.putInt(speedFraction.isPresent() ? 1 : 0);
    out.putFloat((float) speedFraction.orElse(0));
    out.position(REGISTERS);
    for (int group = 0; group < 2; group++) {
      out.putInt((int) (bits >>> (Integer.SIZE * group)));
      for (int i = 0; i < GROUP; i++) {
        out.putInt(words.get(GROUP * group + i));
      }
      out.position(out.position() + Float.BYTES * GROUP);
    }
    return AssemblyData.of(out.flip());
  }

  /**
   * What the scanner asks for.
   *
   * @param data {@link #BYTES} bytes
   */
  public static InputUpdate decode(ByteBuffer data) {
    ByteBuffer in = data.slice().order(ByteOrder.LITTLE_ENDIAN);
    ByteBuffer values = ByteBuffer.allocate(RECIPE.bytes());
    for (InputField field : RECIPE.fields()) {
      if (field.type() == FieldType.DOUBLE) {
        values.putDouble(in.getFloat());
      } else if (field.type() == FieldType.UINT8) {
        values.put(in.get());
      } else {
        values.putInt(in.getInt());
      }
    }
    return RECIPE.decode(values.flip());
  }
}
