package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.CellEquipment;

/** The two-finger gripper by Modbus RTU on the tool's line. */
class RtuProgramTest {
  private final RunningProgram program =
      new RunningProgram(
          ControllerOptions.headless()
              .withEquipment(
                  CellEquipment.NONE.and(
                      List.of(DeviceSetup.of("two-finger-tool").orElseThrow()))));

  private static final String ON = "  set_tool_communication(True, 115200, 0, 1, 1.5, 3.5)\n";
  private static final String TALK =
      """
        socket_open("127.0.0.1", 54321, "line")
        def ask(bytes, count):
          i = 0
          while i < length(bytes):
            socket_send_byte(bytes[i], "line")
            i = i + 1
          end
          return socket_read_byte_list(count, "line", 0.2)
        end
      """;

  private List<String> said(String lines) {
    program.run("def f():\n" + lines + "end\n");
    return program.said();
  }

  @Test
  void messagesOfTheManualAreAnsweredAsItSays() {
    assertEquals(
        List.of("[8, 9, 16, 3, 232, 0, 3, 1, 48]", "[7, 9, 3, 2, 17, 0, 85, 213]"),
        said(
            ON
                + TALK
                + "  textmsg(ask([9, 16, 3, 232, 0, 3, 6, 1, 0, 0, 0, 0, 0, 114, 225], 8))\n"
                + "  textmsg(ask([9, 3, 7, 208, 0, 1, 133, 207], 7))\n"));
  }

  @Test
  void itIsActivatedAndCloses() {
    List<String> answers =
        said(
            ON
                + TALK
                + "  ask([9, 16, 3, 232, 0, 3, 6, 1, 0, 0, 0, 0, 0, 114, 225], 8)\n"
                + "  sleep(2)\n"
                + "  textmsg(ask([9, 3, 7, 208, 0, 1, 133, 207], 7))\n"
                + "  ask([9, 16, 3, 232, 0, 3, 6, 9, 0, 0, 255, 255, 255, 66, 41], 8)\n"
                + "  sleep(1)\n"
                + "  textmsg(ask([9, 3, 7, 208, 0, 3, 4, 14], 11))\n");
    assertTrue(answers.getFirst().startsWith("[7, 9, 3, 2, 241, 0,"), answers.toString());
    assertTrue(
        answers.get(1).startsWith("[11, 9, 3, 6, 249, 0, 0, 255, 230, 0,"), answers.toString());
  }

  @Test
  void wrongChecksumsAndOtherSlavesAreNotAnswered() {
    assertEquals(
        List.of("[0, -1, -1, -1, -1, -1, -1, -1]", "[0, -1, -1, -1, -1, -1, -1, -1]"),
        said(
            ON
                + TALK
                + "  textmsg(ask([9, 3, 7, 208, 0, 1, 133, 200], 7))\n"
                + "  textmsg(ask([8, 3, 7, 208, 0, 1, 133, 207], 7))\n"));
  }

  @Test
  void aRegisterThatIsNotThereIsAnException() {
    assertTrue(
        said(ON + TALK + "  textmsg(ask([9, 3, 0, 0, 0, 1, 133, 66], 5))\n")
            .getFirst()
            .startsWith("[5, 9, 131, 2,"));
  }

  @Test
  void aLineThatIsOffLosesWhatIsSent() {
    assertEquals(
        List.of("[0, -1, -1, -1, -1, -1, -1, -1]"),
        said(TALK + "  textmsg(ask([9, 3, 7, 208, 0, 1, 133, 207], 7))\n"));
    assertTrue(
        program
            .reported()
            .contains(
                "two-finger-tool: the tool's line is off; set_tool_communication(True, ...) turns"
                    + " it on"));
  }
}
