package org.pendant.desktop.waveform;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.WaveformText;
import org.pendant.recording.RecordingRing;

final class WaveformCaptureTest {
  private final Controller controller = new Controller(ControllerOptions.headless());
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);

  private void frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
      ring.take(controller.state());
    }
  }

  private Optional<WaveformCapture> capture() {
    return WaveformCapture.of(ring.recording());
  }

  @Test
  void whatWasPlayedInTheLastRunIsTakenFromItToTheFrame() {
    InputWaveforms waveforms =
        WaveformText.parse(
            "inputs.csv",
            """
            time,signal,value
            0,digital_in[3],false
            0,tool_in[1],true
            0.1,digital_in[3],true
            0.102,digital_in[3],false
            0.5,tool_in[1],false
            """);
    var _ = controller.submit(new IoCommand.PlayInputs(waveforms));
    for (int run = 0; run < 2; run++) {
      frames(100);
      var _ =
          controller.submit(
              new ProgramCommand.StartProgram(
                  TestController.program(
                      controller,
                      """
                      sleep(0.2)
                      set_standard_digital_out(5, True)
                      sleep(0.3)
                      set_standard_digital_out(5, False)
                      sleep(0.2)
                      """)));
      frames(500);
    }
    WaveformCapture capture = capture().orElseThrow();
    assertEquals(waveforms, capture.sheet().waveforms());
    assertEquals(1, capture.outputs().size());
    assertEquals("digital_out[5]", capture.outputs().getFirst().signal());
    assertEquals(List.of(0.2, 0.5), capture.outputs().getFirst().edgesS());
  }

  @Test
  void whereNothingRanNothingIsTaken() {
    frames(10);
    assertEquals(Optional.empty(), capture());
  }
}
