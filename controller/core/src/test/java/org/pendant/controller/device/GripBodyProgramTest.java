package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;

/** Grippers that grip bodies of the scene, and what the arm feels of them. */
class GripBodyProgramTest {
  /** A part of 40 mm on a table, 1 kg, in front of an arm whose tool points down. */
  private static RunningProgram cell(String devices) throws JsonException {
    return cell(devices, 1, 0);
  }

  private static RunningProgram cell(String devices, double massKg, double offM)
      throws JsonException {
    byte[] text =
        ("{'devices': ["
                + devices
                + "], 'objects': [{'type': 'plane', 'name': 'table', 'point': [0, 0, 0], 'normal':"
                + " [0, 0, 1]}, {'type': 'box', 'name': 'part', 'pose': [0.4, "
                + (-0.1 + offM)
                + ", 0.03, 0, 0, 0], 'size': [0.1, 0.04, 0.06], 'mass': "
                + massKg
                + "}]}")
            .replace('\'', '"')
            .getBytes(StandardCharsets.UTF_8);
    return new RunningProgram(
        ControllerOptions.headless()
            .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static final String GRIPPER =
      "{'type': 'gripper', 'name': 'g', 'close': 'tool_out[0]', 'gripped': 'digital_in[2]',"
          + " 'stroke': 0.08}";

  private static final String VACUUM =
      "{'type': 'vacuum', 'name': 'v', 'suck': 'tool_out[0]', 'holds': 'digital_in[2]', 'cup':"
          + " {'force': %s}}";

  private static final String AT = "p[0.4, -0.1, %s, 3.14159265, 0, 0]";

  private static String go(String height) {
    return "  movel(" + AT.formatted(height) + ", a=1.2, v=0.25)\n";
  }

  private static final String START =
      "  set_tcp(p[0, 0, 0.15, 0, 0, 0])\n  movej(" + AT.formatted("0.2") + ", a=3, v=2)\n";

  private static final String GRIP = "  set_tool_digital_out(0, True)\n  sleep(0.5)\n";

  private static final String RELEASE = "  set_tool_digital_out(0, False)\n  sleep(0.8)\n";

  private static final String FORCE = "  sleep(1)\n  textmsg(norm(get_tcp_force()))\n";

  private static void run(RunningProgram program, String... lines) {
    program.run("def f():\n" + START + String.join("", lines) + "end\n");
  }

  private static Pose part(RunningProgram program) {
    return program.state().moved().getFirst().poseInBase();
  }

  @Test
  void aGrippedPartIsLiftedFeltAndPutDown() throws Exception {
    RunningProgram program = cell(GRIPPER);
    run(program, go("0.03"), GRIP, "  textmsg(get_standard_digital_in(2))\n", go("0.2"));
    assertEquals("True", program.said().getFirst());
    assertTrue(
        program.reported().contains("g: part gripped at 40.0 mm with 100 N"),
        () -> program.reported().toString());
    assertEquals(0.2, part(program).z(), 0.002);
    program.run("def g():\n" + FORCE + go("0.032") + RELEASE + go("0.2") + "end\n");
    assertEquals(9.82, Double.parseDouble(program.said().getLast()), 0.0982);
    assertEquals(0.03, part(program).z(), 0.001);
    assertEquals(-0.1, part(program).y(), 0.002);
  }

  @Test
  void aDeclaredPayloadTakesTheWeightOfThePartAway() throws Exception {
    RunningProgram program = cell(GRIPPER);
    run(
        program,
        "  set_target_payload(0.5, [0, 0, 0.1])\n",
        go("0.03"),
        GRIP,
        go("0.2"),
        "  sleep(1)\n  set_target_payload(1.5, [0, 0, 0.1333])\n",
        FORCE,
        go("0.032"),
        RELEASE,
        go("0.2"),
        FORCE);
    assertEquals(0, program.numbers().getFirst(), 0.1);
    assertEquals(0, program.numbers().getLast(), 0.1);
  }

  @Test
  void fingersPushAPartBetweenThem() throws Exception {
    RunningProgram program = cell(GRIPPER, 1, 0.012);
    run(program, go("0.03"), GRIP, "  textmsg(get_standard_digital_in(2))\n");
    assertEquals("True", program.said().getFirst());
    assertEquals(-0.1, part(program).y(), 0.002);
  }

  @Test
  void closingBesideAPartIsNoticed() throws Exception {
    RunningProgram program = cell(GRIPPER);
    run(program, go("0.15"), GRIP, "  textmsg(get_standard_digital_in(2))\n");
    assertEquals("False", program.said().getFirst());
  }

  @Test
  void whatIsHeavierThanFrictionHoldsIsLost() throws Exception {
    String rg = "{'type': 'rg', 'name': 'g'}";
    String grip =
        """
          server = rpc_factory("xmlrpc", "http://localhost:41414")
          server.rg_grip(0, 0.0, %s)
          sleep(1.5)
          textmsg(server.rg_get_grip_detected(0))
        """;
    // 2 fingers, friction 0.49: 39 N hold 3 kg and 10 N do not
    RunningProgram firm = cell(rg, 3, 0);
    run(firm, go("0.03"), grip.formatted("40"), go("0.15"));
    assertEquals("True", firm.said().getFirst());
    assertEquals(0.15, part(firm).z(), 0.005);
    RunningProgram slack = cell(rg, 3, 0);
    run(slack, go("0.03"), grip.formatted("10"), go("0.15"), "  sleep(1)\n");
    assertEquals("True", slack.said().getFirst());
    assertEquals(0.03, part(slack).z(), 0.002);
    assertTrue(slack.reported().contains("g: part let go"), () -> slack.reported().toString());
  }

  @Test
  void aVacuumCupLiftsWhatItsForceHolds() throws Exception {
    RunningProgram program = cell(VACUUM.formatted("60"));
    run(program, go("0.063"), GRIP, go("0.2"), "  textmsg(get_standard_digital_in(2))\n", FORCE);
    assertEquals("True", program.said().getFirst());
    assertEquals(9.82, Double.parseDouble(program.said().get(1)), 0.0982);
    assertEquals(0.17 - 0.003, part(program).z(), 0.002);
    program.run("def g():\n" + RELEASE + "  sleep(1)\nend\n");
    assertEquals(0.03, part(program).z(), 0.002);
  }

  @Test
  void aVacuumCupLosesWhatIsTooHeavy() throws Exception {
    RunningProgram program = cell(VACUUM.formatted("8"));
    run(program, go("0.063"), GRIP, go("0.2"), "  textmsg(get_standard_digital_in(2))\n");
    assertEquals("False", program.said().getFirst());
    assertTrue(program.reported().contains("v: part lost"), () -> program.reported().toString());
    assertEquals(0.03, part(program).z(), 0.002);
  }

  @Test
  void runsWithGrippedPartsRepeatToTheBit() throws Exception {
    Pose first = repeated();
    for (int i = 0; i < 2; i++) {
      assertEquals(first, repeated());
    }
  }

  private static Pose repeated() throws Exception {
    RunningProgram program = cell(GRIPPER, 1, 0.008);
    run(program, go("0.03"), GRIP, go("0.2"));
    return part(program);
  }
}
