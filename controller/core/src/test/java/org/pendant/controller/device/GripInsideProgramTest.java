package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;

/** Grippers whose fingers open inside a part, and hold it from there. */
@Tag("slow")
class GripInsideProgramTest {
  /** A cup that is 60 mm wide inside and 60 mm high, on a table, in front of an arm. */
  private static ControllerOptions options(String device, double massKg, double offM)
      throws JsonException {
    byte[] text =
        """
        {"devices": [%s],
         "objects": [
           {"type": "plane", "name": "table", "point": [0, 0, 0], "normal": [0, 0, 1]},
           {"type": "compound", "name": "cup", "pose": [0.4, %s, 0, 0, 0, 0], "mass": %s, "parts": [
             {"type": "box", "pose": [0, 0, 0.005, 0, 0, 0], "size": [0.08, 0.08, 0.01]},
             {"type": "box", "pose": [0.035, 0, 0.035, 0, 0, 0], "size": [0.01, 0.08, 0.05]},
             {"type": "box", "pose": [-0.035, 0, 0.035, 0, 0, 0], "size": [0.01, 0.08, 0.05]},
             {"type": "box", "pose": [0, 0.035, 0.035, 0, 0, 0], "size": [0.06, 0.01, 0.05]},
             {"type": "box", "pose": [0, -0.035, 0.035, 0, 0, 0], "size": [0.06, 0.01, 0.05]}]}]}
        """
            .formatted(device, -0.1 + offM, massKg)
            .getBytes(StandardCharsets.UTF_8);
    return ControllerOptions.headless()
        .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
        .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text)));
  }

  private static final String GRIPPER =
      """
      {"type": "gripper", "name": "g", "close": "tool_out[0]", "gripped": "digital_in[2]",
       "stroke": 0.08}\
      """;

  private static final String AT = "p[0.4, -0.1, %s, 3.14159265, 0, 0]";

  private static String go(double height) {
    return "  movel(" + AT.formatted(height) + ", a=1.2, v=0.25)\n";
  }

  private static final String START =
      "  set_tcp(p[0, 0, 0.15, 0, 0, 0])\n  set_tool_digital_out(0, True)\n  movej("
          + AT.formatted("0.2")
          + ", a=3, v=2)\n  sleep(0.5)\n";

  private static final String OPEN = "  set_tool_digital_out(0, False)\n  sleep(0.5)\n";
  private static final String CLOSE = "  set_tool_digital_out(0, True)\n  sleep(0.5)\n";

  private static void run(RunningProgram program, String... lines) {
    program.run("def f():\n" + START + String.join("", lines) + "end\n");
  }

  private static Pose cup(RunningProgram program) {
    return program.state().moved().getFirst().poseInBase();
  }

  @ParameterizedTest
  @EnumSource
  void aCupIsHeldFromTheInsideLiftedFeltAndPutDown(ArmChoice arm) throws Exception {
    RunningProgram program = new RunningProgram(options(GRIPPER, 1, 0).withArm(arm));
    run(program, go(0.04), OPEN, "  textmsg(get_standard_digital_in(2))\n", go(0.2));
    assertEquals("True", program.said().getFirst());
    assertTrue(
        program.reported().contains("g: part gripped from inside at 44.0 mm with 100 N"),
        () -> program.reported().toString());
    assertEquals(0.16, cup(program).z(), 0.002);
    program.run(
        "def g():\n  sleep(1)\n  textmsg(norm(get_tcp_force()))\n"
            + go(0.041)
            + CLOSE
            + go(0.2)
            + "end\n");
    assertEquals(9.82, Double.parseDouble(program.said().getLast()), 0.0982);
    assertEquals(0, cup(program).z(), 0.001);
    assertEquals(-0.1, cup(program).y(), 0.002);
  }

  @Test
  void fingersPushACupThatIsNotInTheMiddle() throws Exception {
    RunningProgram program = new RunningProgram(options(GRIPPER, 0.3, 0.01));
    run(program, go(0.04), OPEN, "  textmsg(get_standard_digital_in(2))\n", go(0.2));
    assertEquals("True", program.said().getFirst());
    assertEquals(-0.1, cup(program).y(), 0.002);
    assertEquals(0.16, cup(program).z(), 0.002);
  }

  @Test
  void closingLetsItGoInTheSameFrame() throws Exception {
    RunningProgram program = new RunningProgram(options(GRIPPER, 0.3, 0));
    run(program, go(0.04), OPEN, go(0.2));
    double z = cup(program).z();
    program.start("set_tool_digital_out(0, True)\nsleep(1)\n");
    program.advance(50);
    double fallsM = 9.82 * 0.1 * 0.1 / 2;
    assertEquals(z - fallsM, cup(program).z(), 0.1 * fallsM);
  }

  @Test
  void fingersThatOpenAboveACupHoldNothing() throws Exception {
    RunningProgram program = new RunningProgram(options(GRIPPER, 0.3, 0));
    run(program, go(0.09), OPEN, "  textmsg(get_standard_digital_in(2))\n");
    assertEquals("False", program.said().getFirst());
  }

  @Test
  void whatIsHeavierThanFrictionHoldsIsLost() throws Exception {
    String grip =
        """
          server = rpc_factory("xmlrpc", "http://localhost:41414")
          server.rg_grip(0, 0.0, 40.0)
          sleep(1.5)
        %s  server.rg_grip(0, 110.0, %s)
          sleep(1.5)
          textmsg(server.rg_get_grip_detected(0))
        """;
    // 2 fingers, friction 0.49: 39 N hold 3 kg and 10 N do not
    String rg = "{\"type\": \"rg\", \"name\": \"g\"}";
    RunningProgram firm = new RunningProgram(options(rg, 3, 0));
    run(firm, grip.formatted(go(0.04), "40.0"), go(0.15));
    assertEquals("True", firm.said().getFirst());
    assertEquals(0.11, cup(firm).z(), 0.005);
    RunningProgram slack = new RunningProgram(options(rg, 3, 0));
    run(slack, grip.formatted(go(0.04), "10.0"), go(0.15), "  sleep(1)\n");
    assertEquals("True", slack.said().getFirst());
    assertEquals(0, cup(slack).z(), 0.002);
    assertTrue(slack.reported().contains("g: part let go"), () -> slack.reported().toString());
  }

  @Test
  void widthsOfAGripFromInsideCountBetweenTheOuterSidesOfTheFingers() throws Exception {
    RunningProgram program =
        new RunningProgram(options("{\"type\": \"2fg\", \"name\": \"g\"}", 1, 0));
    run(
        program,
        """
          server = rpc_factory("xmlrpc", "http://localhost:41414")
          server.twofg_grip_internal(0, 36.0, 20.0, 100)
          sleep(1)
          textmsg(server.twofg_get_internal_width(0))
          textmsg(server.twofg_get_external_width(0))
        """);
    assertEquals(36, program.numbers().getFirst(), 1e-6);
    assertEquals(20, program.numbers().getLast(), 1e-6);
  }

  @Test
  void theTwoFingerGripperTellsWhatItMetWhileItOpened() throws Exception {
    String socket =
        """
          socket_open("127.0.0.1", 63352, "g")
          socket_set_var("POS", 255, "g")
          socket_read_byte_list(3, "g")
          sleep(1)
        %s  socket_set_var("POS", 0, "g")
          socket_read_byte_list(3, "g")
          sleep(1)
          textmsg(socket_get_var("OBJ", "g"))
        """;
    RunningProgram program =
        new RunningProgram(options("{\"type\": \"two-finger\", \"name\": \"g\"}", 1, 0));
    run(program, socket.formatted(go(0.04)), go(0.2));
    assertEquals("1", program.said().getFirst());
    assertEquals(0.16, cup(program).z(), 0.002);
  }

  @Test
  void runsRepeatToTheBit() throws Exception {
    Pose first = repeated();
    assertEquals(first, repeated());
  }

  private static Pose repeated() throws Exception {
    RunningProgram program = new RunningProgram(options(GRIPPER, 0.5, 0.006));
    run(program, go(0.04), OPEN, go(0.2));
    return cup(program);
  }
}
