package org.pendant.controller.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.HashSet;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.models.pose.Wrench;

class InputRecipeTest {
  private static InputRecipe recipe(String... names) {
    return new InputRecipe(
        Arrays.stream(names).map(name -> InputFields.of(name).orElseThrow()).toList());
  }

  private static InputUpdate decode(InputRecipe recipe, String hex) {
    byte[] bytes = HexFormat.of().parseHex(hex.replace(" ", ""));
    return recipe.decode(ByteBuffer.wrap(bytes));
  }

  private static SignalWrite digital(SignalBank bank, int index, boolean level) {
    return new SignalWrite.Digital(new Signal(bank, index), level);
  }

  @Test
  void hasAllInputsAndOnlyThose() {
    assertEquals(2 + 6 + 4 + 2 + 64 + 48 + 48 + 1, InputFields.all().size());
    for (InputField field : InputFields.all()) {
      assertEquals(Optional.of(field), InputFields.of(field.name()));
    }
    assertEquals(FieldType.BOOL, InputFields.of("input_bit_register_64").orElseThrow().type());
    assertEquals(FieldType.INT32, InputFields.of("input_int_register_47").orElseThrow().type());
    assertEquals(Optional.empty(), InputFields.of("input_bit_register_63"));
    assertEquals(Optional.empty(), InputFields.of("input_int_register_48"));
    assertEquals(Optional.empty(), InputFields.of("actual_q"));
    assertEquals(Optional.empty(), InputFields.of(""));
  }

  @Test
  void noTwoInputsAreTheSameThing() {
    Set<String> claims = new HashSet<>();
    for (InputField field : InputFields.all()) {
      assertTrue(!field.claims().isEmpty(), field.name());
      for (String claim : field.claims()) {
        assertTrue(claims.add(claim), claim);
      }
    }
  }

  @Test
  void theMaskSelectsOutputsWhereverItStands() {
    List<SignalWrite> expected =
        List.of(
            digital(SignalBank.STANDARD_OUT, 0, true), digital(SignalBank.STANDARD_OUT, 7, false));
    InputRecipe maskFirst = recipe("standard_digital_output_mask", "standard_digital_output");
    InputRecipe maskLast = recipe("standard_digital_output", "standard_digital_output_mask");
    assertEquals(expected, decode(maskFirst, "81 0f").writes());
    assertEquals(expected, decode(maskLast, "0f 81").writes());
    assertEquals(List.of(), decode(maskFirst, "00 ff").writes());
    assertEquals(List.of(), decode(recipe("standard_digital_output"), "ff").writes());
  }

  @Test
  void theToolHasTwoOutputs() {
    InputRecipe tool = recipe("tool_digital_output_mask", "tool_digital_output");
    assertEquals(
        List.of(digital(SignalBank.TOOL_OUT, 0, false), digital(SignalBank.TOOL_OUT, 1, true)),
        decode(tool, "ff fe").writes());
  }

  @Test
  void analogOutputsAreRatiosOfTheirDomain() {
    InputRecipe analog =
        recipe(
            "standard_analog_output_mask",
            "standard_analog_output_type",
            "standard_analog_output_0",
            "standard_analog_output_1");
    assertEquals(
        List.of(
            new SignalWrite.Domain(AnalogBank.STANDARD_OUT, 1, AnalogDomain.VOLTAGE),
            new SignalWrite.AnalogOutput(1, 0.5)),
        decode(analog, "02 02 3ff0000000000000 3fe0000000000000").writes());
  }

  @Test
  void aRatioThatCannotBeIsIgnoredWithAReason() {
    InputRecipe analog = recipe("standard_analog_output_mask", "standard_analog_output_0");
    InputUpdate update = decode(analog, "01 7ff8000000000000");
    assertEquals(List.of(), update.writes());
    assertEquals(List.of("standard_analog_output_0 is NaN, must be 0 to 1"), update.ignored());
    assertEquals(List.of(), decode(analog, "00 7ff8000000000000").ignored());
  }

  @Test
  void theSpeedSliderMovesWhenItsMaskSaysSo() {
    InputRecipe slider = recipe("speed_slider_mask", "speed_slider_fraction");
    assertEquals(
        OptionalDouble.of(0.5), decode(slider, "00000001 3fe0000000000000").speedFraction());
    assertEquals(
        OptionalDouble.empty(), decode(slider, "00000000 3fe0000000000000").speedFraction());
    InputUpdate tooFast = decode(slider, "00000001 4000000000000000");
    assertEquals(OptionalDouble.empty(), tooFast.speedFraction());
    assertEquals(List.of("speed_slider_fraction is 2.0, must be 0 to 1"), tooFast.ignored());
  }

  @Test
  void registersAreWrittenAsTheyCome() {
    InputRecipe registers =
        recipe("input_int_register_3", "input_double_register_47", "input_bit_register_127");
    assertEquals(
        List.of(
            new SignalWrite.IntegerRegister(RegisterDirection.INPUT, 3, -2),
            new SignalWrite.FloatRegister(RegisterDirection.INPUT, 47, 1.5),
            new SignalWrite.BooleanRegister(RegisterDirection.INPUT, 127, true)),
        decode(registers, "fffffffe 3ff8000000000000 05").writes());
  }

  @Test
  void bitsComeThirtyTwoAtATime() {
    List<SignalWrite> writes = decode(recipe("input_bit_registers32_to_63"), "80000002").writes();
    assertEquals(32, writes.size());
    for (int i = 0; i < 32; i++) {
      assertEquals(
          new SignalWrite.BooleanRegister(RegisterDirection.INPUT, 32 + i, i == 1 || i == 31),
          writes.get(i));
    }
  }

  @Test
  void anExternalWrenchHasToBeFinite() {
    InputRecipe sensor = recipe("external_force_torque");
    String one = "3ff0000000000000";
    assertEquals(
        Optional.of(new Wrench(1, 1, 1, 1, 1, 1)), decode(sensor, one.repeat(6)).externalWrench());
    InputUpdate endless = decode(sensor, one.repeat(5) + "7ff0000000000000");
    assertEquals(Optional.empty(), endless.externalWrench());
    assertEquals(List.of("external_force_torque has Infinity, must be finite"), endless.ignored());
  }

  @Test
  void aPackageHasExactlyItsBytes() {
    InputRecipe slider = recipe("speed_slider_mask", "speed_slider_fraction");
    assertEquals(12, slider.bytes());
    for (int bytes = 0; bytes < 20; bytes++) {
      ByteBuffer values = ByteBuffer.allocate(bytes);
      if (bytes == 12) {
        assertEquals(List.of(), slider.decode(values).writes());
      } else {
        assertThrows(IllegalArgumentException.class, () -> slider.decode(values));
      }
    }
  }
}
