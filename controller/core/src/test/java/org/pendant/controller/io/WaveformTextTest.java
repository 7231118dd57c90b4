package org.pendant.controller.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.junit.jupiter.api.Test;

final class WaveformTextTest {
  private static InputWaveforms parse(String... lines) {
    return WaveformText.parse("inputs.csv", String.join("\n", lines));
  }

  private static void refuses(String message, String... lines) {
    assertEquals(
        message, assertThrows(IllegalArgumentException.class, () -> parse(lines)).getMessage());
  }

  @Test
  void aTableHasALineForEachChange() {
    InputWaveforms waveforms =
        parse(
            "time, signal, value",
            "# the feeder",
            "",
            "2.5, digital_in[0], true",
            "0,analog_in[1],7.5V",
            "10,repeat,");
    assertEquals(
        new InputWaveforms(
            List.of(
                new InputChange(0, "analog_in[1]", "7.5V"),
                new InputChange(2.5, "digital_in[0]", "true")),
            OptionalDouble.of(10)),
        waveforms);
  }

  @Test
  void mistakesAreToldWithTheirPlace() {
    refuses("inputs.csv:1:1: no lines, the first must be time,signal,value", "");
    refuses(
        "inputs.csv:1:1: line is '0,digital_in[0],true', the first must be time,signal,value",
        "0,digital_in[0],true");
    refuses(
        "inputs.csv:2:1: line has 2 cells, must have 3: time,signal,value",
        "time,signal,value",
        "0,digital_in[0]");
    refuses(
        "inputs.csv:2:1: time is 'soon', must be a number of seconds",
        "time,signal,value",
        "soon,digital_in[0],true");
    refuses(
        "inputs.csv:2:1: time is -1.0 s, must be 0 to 604800 s",
        "time,signal,value",
        "-1,digital_in[0],true");
    refuses(
        "inputs.csv:2:5: level is maybe, must be true or false",
        "time,signal,value",
        "2.5,digital_in[0],maybe");
    refuses(
        "inputs.csv:3:3: a second line says when to repeat",
        "time,signal,value",
        "1,repeat,",
        "2,repeat,");
    refuses(
        "inputs.csv: change at 3.0 s, must be before the period of 2.0 s is over",
        "time,signal,value",
        "3,digital_in[0],true",
        "2,repeat,");
  }

  @Test
  void aTableIsBoundedAndAsManyChangesInOneFrameAreRead() {
    String all =
        "time,signal,value\n" + "1,digital_in[0],true\n".repeat(InputWaveforms.MAX_CHANGES);
    assertEquals(
        InputWaveforms.MAX_CHANGES, WaveformText.parse("inputs.csv", all).changes().size());
    refuses("inputs.csv:100002:1: more than 100000 changes", all + "1,digital_in[0],true");
  }

  @Test
  void anInputThatIsNoneIsToldAtItsCell() {
    String message =
        assertThrows(UnknownSignal.class, () -> SignalText.input("digital_out[0]", "true"))
            .getMessage();
    refuses("inputs.csv:2:3: " + message, "time,signal,value", "0,digital_out[0],true");
  }

  @Test
  void whatIsWrittenIsReadAgain() {
    Random random = new Random(11);
    List<String> signals = List.of("digital_in[0]", "tool_in[1]", "input_boolean_register[70]");
    for (int i = 0; i < 50; i++) {
      List<InputChange> changes = new ArrayList<>();
      for (int n = random.nextInt(20); n > 0; n--) {
        changes.add(
            new InputChange(
                random.nextInt(5_000) * 0.002,
                signals.get(random.nextInt(signals.size())),
                Boolean.toString(random.nextBoolean())));
      }
      InputWaveforms waveforms =
          new InputWaveforms(
              changes, random.nextBoolean() ? OptionalDouble.of(10.5) : OptionalDouble.empty());
      assertEquals(waveforms, WaveformText.parse("x", WaveformText.format(waveforms)));
    }
  }
}
