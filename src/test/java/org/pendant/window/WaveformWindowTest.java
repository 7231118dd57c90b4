package org.pendant.window;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** Inputs that change as people have drawn, while a program runs. */
@Tag("slow")
final class WaveformWindowTest {
  @RegisterExtension static final SharedWindow sharedWindow = new SharedWindow();

  private final OpenWindow window = sharedWindow.window();

  @Test
  void anInputIsDrawnByKeysAndPlaysWithTheProgram() {
    window.perform("Show Waveforms");
    window.awaitWords("waveform-note", "Nothing happens at the inputs");
    window.click("waveform-add");
    window.awaitFocus("waveform-canvas");
    window.press("shift RIGHT");
    window.press("SPACE");
    window.click("waveform-play");
    sharedWindow.run(
        "while not get_standard_digital_in(0):",
        "  sync()",
        "end",
        "set_standard_digital_out(3, True)",
        "textmsg(\"it came\")",
        "sleep(0.2)");
    window.awaitWords("run-messages", "it came");
    window.awaitWords("program-state", "stopped");
    window.click("waveform-play");
  }

  @Test
  void whatIsNoInputIsRefusedAtTheField() {
    window.perform("Show Waveforms");
    window.click("waveform-signal-text");
    window.press("control A");
    window.type("digital_out[1]");
    window.click("waveform-add");
    window.awaitWords("waveform-remark", "input is 'digital_out[1]', must be one of digital_in[0]");
  }
}
