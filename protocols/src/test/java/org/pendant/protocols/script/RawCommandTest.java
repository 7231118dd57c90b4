package org.pendant.protocols.script;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import org.junit.jupiter.api.Test;

class RawCommandTest {
  private static void assertRead(RawCommand expected, String line) {
    assertEquals(Optional.of(expected), RawCommand.read(line));
  }

  @Test
  void readsEveryCommand() {
    assertRead(new RawCommand.PowerOn(), "power on");
    assertRead(new RawCommand.PowerOff(), "power off");
    assertRead(new RawCommand.Run(), "set robotmode run");
    assertRead(new RawCommand.Freedrive(), "set robotmode freedrive");
    assertRead(new RawCommand.UnlockProtectiveStop(), "set unlock protective stop");
    assertRead(new RawCommand.StopProgram(), "stop program");
    assertRead(new RawCommand.SetSpeed(0.5), "set speed 0.5");
    assertRead(new RawCommand.SetSpeed(1), "set speed 1");
    assertRead(new RawCommand.ChooseArm(true), "set real");
    assertRead(new RawCommand.ChooseArm(false), "set sim");
  }

  @Test
  void blanksDoNotCount() {
    assertRead(new RawCommand.Run(), "  set  robotmode\trun ");
    assertRead(new RawCommand.SetSpeed(0.25), " set speed  .25 ");
  }

  @Test
  void theAnswerToATextKeepsItsBlanks() {
    assertRead(new RawCommand.AnswerRequest(3, "12.5"), "request_value 3 12.5");
    assertRead(new RawCommand.AnswerRequest(4, " two words "), "request_value 4  two words ");
    assertRead(new RawCommand.AnswerRequest(5, ""), "request_value 5");
  }

  @Test
  void everythingElseIsScript() {
    for (String line :
        new String[] {
          "power",
          "Power on",
          "set speed",
          "set speed .",
          "set speed -1",
          "set speed fast",
          "request_value x 1",
          "request_value 1234567890123456789 1",
          "stop program now",
          "set_digital_out(1, True)"
        }) {
      assertEquals(Optional.empty(), RawCommand.read(line), line);
    }
  }
}
