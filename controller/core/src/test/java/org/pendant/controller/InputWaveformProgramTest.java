package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.WaveformText;

/** Programs whose inputs change by the time since their start. */
final class InputWaveformProgramTest {
  private static final String WATCH =
      """
      t = 0
      was = False
      while t < 20:
        is = get_standard_digital_in(0)
        if is != was:
          textmsg(t, is)
          was = is
        end
        t = t + 1
        sync()
      end
      """;

  private final RunningProgram robot = new RunningProgram();

  private void play(String... lines) {
    String table = "time,signal,value\n" + String.join("\n", lines);
    robot.done(new IoCommand.PlayInputs(WaveformText.parse("inputs.csv", table)));
  }

  @Test
  void aChangeComesWithItsFrameBeforeTheScript() {
    play("0,digital_in[0],true", "0.002,digital_in[0],false", "0.0051,digital_in[0],true");
    robot.run(WATCH);
    assertEquals(List.of("0True", "1False", "3True"), robot.said());
  }

  @Test
  void everythingHappensAgainAfterThePeriod() {
    play("0.004,digital_in[0],true", "0.010,digital_in[0],false", "0.014,repeat,");
    robot.run(WATCH);
    assertEquals(List.of("2True", "5False", "9True", "12False", "16True", "19False"), robot.said());
  }

  @Test
  void eachProgramBeginsWithTheFirstChange() {
    play("0.004,digital_in[0],true", "0.030,digital_in[0],false");
    robot.run(WATCH);
    robot.advance(100);
    robot.done(new IoCommand.SetInput("digital_in[0]", false));
    robot.run(WATCH);
    assertEquals(List.of("2True", "15False", "2True", "15False"), robot.said());
  }

  @Test
  void aSignalThatAClientHasTakenIsLeftToItAndToldOnce() {
    play("0,input_boolean_register[64],true", "0.01,input_boolean_register[64],false");
    robot.done(new IoCommand.ClaimSignal("plc", "input_boolean_register[64]"));
    robot.run("sleep(0.1)\ntextmsg(read_input_boolean_register(64))\n");
    assertEquals(List.of("False"), robot.said());
    assertEquals(
        1, robot.reported().stream().filter(each -> each.contains("input waveform: ")).count());
  }

  @Test
  void whatIsChangedWhileAProgramRunsCountsFromThereOn() {
    robot.start(WATCH);
    robot.advance(4);
    play("0.002,digital_in[0],true", "0.020,digital_in[0],true", "0.030,digital_in[0],false");
    robot.finish();
    assertEquals(List.of("10True", "15False"), robot.said());
  }

  @Test
  void noneAnyMoreLeavesInputsAlone() {
    play("0,digital_in[0],true");
    robot.done(new IoCommand.PlayInputs(InputWaveforms.NONE));
    robot.run(WATCH);
    assertEquals(List.of(), robot.said());
  }
}
