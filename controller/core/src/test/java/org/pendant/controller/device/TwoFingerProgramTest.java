package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.CellEquipment;
import org.pendant.controller.box.WorldCommand;

/** The two-finger gripper as programs in the wild talk to it. */
class TwoFingerProgramTest {
  private static RunningProgram with(boolean activated, double partWidthM) {
    return new RunningProgram(
        ControllerOptions.headless()
            .withEquipment(
                CellEquipment.NONE.and(
                    List.of(new DeviceSetup.TwoFinger("gripper", false, activated, partWidthM)))));
  }

  private static List<String> said(RunningProgram program, String lines) {
    program.run("def f():\n" + lines + "end\n");
    return program.said();
  }

  private static final String OPEN = "  socket_open(\"127.0.0.1\", 63352, \"gripper_socket\")\n";

  @Test
  void opensAtTheControllersOwnAddress() {
    assertEquals(
        List.of("True", "True"),
        said(
            with(true, 0),
            """
              textmsg(socket_open("127.0.0.1", 63352, "a"))
              textmsg(socket_open("localhost", 63352, "b"))
            """));
  }

  @Test
  void isNotThereWithoutTheDevice() {
    RunningProgram program = new RunningProgram();
    program.start("def f():\n" + OPEN + "end\n");
    program.finish();
    assertTrue(program.reported().toString().contains("no way to the outside"));
  }

  @Test
  void variablesAreSetWithoutAnythingElse() {
    RunningProgram program = with(true, 0);
    assertEquals(
        List.of("230"),
        said(
            program,
            OPEN
                + "  socket_set_var(\"SPE\", 255, \"gripper_socket\")\n"
                + "  socket_set_var(\"FOR\", 20, \"gripper_socket\")\n"
                + "  socket_set_var(\"POS\", 255, \"gripper_socket\")\n"
                + "  socket_close(\"gripper_socket\")\n"
                + "  sleep(0.7)\n"
                + OPEN
                + "  textmsg(socket_get_var(\"POS\", \"gripper_socket\"))\n"));
  }

  @Test
  void whatWasSentRightBeforeTheEndIsCarriedOut() {
    RunningProgram program = with(true, 0);
    said(program, OPEN + "  socket_set_var(\"POS\", 255, \"gripper_socket\")\n");
    program.advance(400);
    assertEquals(
        List.of("230"),
        said(program, OPEN + "  textmsg(socket_get_var(\"POS\", \"gripper_socket\"))\n"));
  }

  @Test
  void anAcknowledgementHasThreeBytesAndABareQuestionOne() {
    assertEquals(
        List.of("[3, 97, 99, 107]", "[1, 51]", "[2, 48, 48]", "[3, 48, 49, 50]"),
        said(
            with(true, 0),
            OPEN
                + "  socket_set_var(\"POS\", 12, \"gripper_socket\")\n"
                + "  sync()\n"
                + "  textmsg(socket_read_byte_list(3, \"gripper_socket\"))\n"
                + bare("STA", 1)
                + bare("FLT", 2)
                + bare("PRE", 3)));
  }

  private static String bare(String name, int bytes) {
    return "  socket_send_string(\"GET "
        + name
        + "\", \"gripper_socket\")\n  sync()\n  textmsg(socket_read_byte_list("
        + bytes
        + ", \"gripper_socket\"))\n";
  }

  @Test
  void aLineInTwoPiecesIsAnsweredByNameAndNumber() {
    assertEquals(
        List.of("STA 3"),
        said(
            with(true, 0),
            OPEN
                + "  socket_send_string(\"GET STA\", \"gripper_socket\")\n"
                + "  socket_send_byte(10, \"gripper_socket\")\n"
                + "  textmsg(socket_read_line(\"gripper_socket\", 0.1))\n"));
  }

  @Test
  void severalVariablesStandInOneLine() {
    assertEquals(
        List.of("ack", "100", "7"),
        said(
            with(true, 0),
            OPEN
                + "  socket_send_line(\"SET POS 100 SPE 7 FOR 9 GTO 1\", \"gripper_socket\")\n"
                + "  textmsg(socket_read_string(\"gripper_socket\"))\n"
                + "  textmsg(socket_get_var(\"PRE\", \"gripper_socket\"))\n"
                + "  textmsg(socket_get_var(\"SPE\", \"gripper_socket\"))\n"));
  }

  @Test
  void whatIsNoCommandIsAnsweredByAQuestionMarkAndExplainedInTheLog() {
    RunningProgram program = with(true, 0);
    assertEquals(
        List.of("?", "?", "?"),
        said(
            program,
            OPEN
                + "  socket_send_line(\"rq_open()\", \"gripper_socket\")\n"
                + "  textmsg(socket_read_string(\"gripper_socket\"))\n"
                + "  socket_send_line(\"SET POS 300\", \"gripper_socket\")\n"
                + "  textmsg(socket_read_string(\"gripper_socket\"))\n"
                + "  socket_send_line(\"GET XYZ\", \"gripper_socket\")\n"
                + "  textmsg(socket_read_string(\"gripper_socket\"))\n"));
    assertTrue(
        program
            .reported()
            .containsAll(
                List.of(
                    "gripper: \"rq_open()\": must be SET NAME NUMBER ... or GET NAME",
                    "gripper: \"SET POS 300\": POS is 300, must be 0 to 255",
                    "gripper: \"GET XYZ\": XYZ is no variable of this gripper")),
        program.reported().toString());
  }

  /** The helpers that generated programs bring along, in our words. */
  private static final String HELPERS =
      """
        def tell(name, value):
          sync()
          socket_set_var(name, value, "1")
          sync()
          ack = socket_read_byte_list(3, "1")
          while (not (ack[0] == 3 and ack[1] == 97 and ack[2] == 99 and ack[3] == 107)):
            textmsg("retry")
            socket_set_var(name, value, "1")
            ack = socket_read_byte_list(3, "1")
          end
        end
        def digit(name):
          socket_send_string("GET ", "1")
          socket_send_string(name, "1")
          sync()
          answer = socket_read_byte_list(1, "1")
          return answer[1] - 48
        end
        def activate():
          if digit("STA") != 3:
            tell("ACT", 0)
            tell("ATR", 0)
          end
          tell("ACT", 1)
          while digit("STA") != 3:
            sleep(0.1)
          end
        end
        def move(pos):
          tell("GTO", 0)
          tell("POS", pos)
          socket_send_string("GET PRE", "1")
          sync()
          pre = socket_read_byte_list(3, "1")
          if (pre[1] - 48) * 100 + (pre[2] - 48) * 10 + pre[3] - 48 != pos:
            textmsg("other request")
          end
          tell("GTO", 1)
          while digit("OBJ") == 0:
            sleep(0.01)
            sync()
          end
          return digit("OBJ")
        end
        socket_open("127.0.0.1", 63352, "1")
        tell("SID", 9)
        activate()
      """;

  @Test
  void generatedProgramsActivateItCloseItAndOpenIt() {
    RunningProgram program = with(false, 0);
    assertEquals(
        List.of("3", "3"), said(program, HELPERS + "  textmsg(move(255))\n  textmsg(move(0))\n"));
    assertTrue(program.reported().contains("gripper: activated"));
  }

  @Test
  void generatedProgramsFindAPart() {
    RunningProgram program = with(false, 0.03);
    assertEquals(
        List.of("2", "150", "3"),
        said(
            program,
            HELPERS
                + "  textmsg(move(255))\n"
                + "  textmsg(socket_get_var(\"POS\", \"1\"))\n"
                + "  textmsg(move(100))\n"));
    assertTrue(
        program.reported().contains("gripper: part gripped at 30.0 mm with 235 N"),
        program.reported().toString());
  }

  @Test
  void activationTakesTheTimeOfItsTravel() {
    RunningProgram program = with(false, 0);
    program.start("def f():\n" + HELPERS + "  textmsg(\"ready\")\nend\n");
    program.until("ready");
    assertEquals(1.75, program.state().timeS(), 0.1);
  }

  @Test
  void movingBeforeActivationIsAFault() {
    assertEquals(
        List.of("7", "0", "3"),
        said(
            with(false, 0),
            OPEN
                + "  socket_send_line(\"SET GTO 1\", \"gripper_socket\")\n"
                + "  socket_read_byte_list(3, \"gripper_socket\")\n"
                + "  textmsg(socket_get_var(\"FLT\", \"gripper_socket\"))\n"
                + "  textmsg(socket_get_var(\"STA\", \"gripper_socket\"))\n"
                + "  textmsg(socket_get_var(\"POS\", \"gripper_socket\"))\n"));
  }

  @Test
  void movingWhileItIsActivatedWaits() {
    assertEquals(
        List.of("5", "0", "230"),
        said(
            with(false, 0),
            OPEN
                + "  socket_send_line(\"SET ACT 1 GTO 1 POS 255\", \"gripper_socket\")\n"
                + "  socket_read_byte_list(3, \"gripper_socket\")\n"
                + "  textmsg(socket_get_var(\"FLT\", \"gripper_socket\"))\n"
                + "  sleep(3)\n"
                + "  textmsg(socket_get_var(\"FLT\", \"gripper_socket\"))\n"
                + "  textmsg(socket_get_var(\"POS\", \"gripper_socket\"))\n"));
  }

  @Test
  void aPartThatIsTakenAwayIsLost() {
    RunningProgram program = with(true, 0.03);
    program.start(
        "def f():\n"
            + OPEN
            + "  socket_set_var(\"POS\", 255, \"gripper_socket\")\n"
            + "  socket_read_byte_list(3, \"gripper_socket\")\n"
            + "  sleep(1)\n"
            + "  textmsg(socket_get_var(\"OBJ\", \"gripper_socket\"))\n"
            + "  sleep(1)\n"
            + "  textmsg(socket_get_var(\"OBJ\", \"gripper_socket\"))\n"
            + "end\n");
    program.until("2");
    program.done(new WorldCommand.PutPart("gripper", 0));
    program.finish();
    assertEquals(List.of("2", "3"), program.said());
    assertTrue(program.reported().contains("gripper: part lost"));
  }

  @Test
  void theSnapshotTellsWhatItIsAtAndIsTheSameWhileNothingChanges() {
    RunningProgram program = with(true, 0.03);
    said(program, OPEN + "  socket_set_var(\"POS\", 255, \"gripper_socket\")\n  sleep(1)\n");
    List<DeviceState> devices = program.state().devices();
    assertEquals(
        List.of(
            new DeviceState(
                "gripper", "two-finger gripper", 0.085, 0.03, 235, true, 0.085, 0.03, 63352)),
        devices);
    program.advance(1);
    assertSame(devices, program.state().devices());
  }

  @Test
  void clocksDoNotWaitForIt() {
    RunningProgram program = with(true, 0);
    program.start("def f():\n" + OPEN + "  socket_read_byte_list(1, \"gripper_socket\", 5)\nend\n");
    program.advance(100);
    assertFalse(program.waitsForOutside());
    assertTrue(program.repeats());
  }

  @Test
  void twoControllersHaveTheirOwn() {
    RunningProgram one = with(true, 0);
    RunningProgram other = with(true, 0);
    said(one, OPEN + "  socket_set_var(\"POS\", 255, \"gripper_socket\")\n  sleep(1)\n");
    String ask = OPEN + "  textmsg(socket_get_var(\"POS\", \"gripper_socket\"))\n";
    assertEquals(List.of("230"), said(one, ask));
    assertEquals(List.of("3"), said(other, ask));
  }
}
