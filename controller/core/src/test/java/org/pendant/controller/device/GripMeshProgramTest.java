package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.MeshFiles;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.pose.Pose;

/** Grippers and sensors know meshes with a mass as they know boxes. */
class GripMeshProgramTest {
  /** A block of 100 x 40 x 60 mm whose file has its origin at a corner. */
  private static final MeshFiles FILES =
      (name, unit) ->
          ConvexHull.block(0.1, 0.04, 0.06)
              .seenFrom(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1, -0.05, -0.02, -0.03})
              .surface();

  private static final String AT = "p[0.4, -0.1, %s, 3.14159265, 0, 0]";
  private static final String GRIP = "  set_tool_digital_out(0, True)\n  sleep(0.5)\n";

  /** The block on a table, 1 kg, in front of an arm whose tool points down. */
  private static RunningProgram cell(String devices) throws JsonException {
    byte[] text =
        ("{'devices': ["
                + devices
                + "], 'objects': [{'type': 'plane', 'name': 'table', 'point': [0, 0, 0], 'normal':"
                + " [0, 0, 1]}, {'type': 'mesh', 'name': 'part', 'pose': [0.35, -0.12, 0, 0, 0,"
                + " 0], 'mesh': 'a.stl', 'unit': 'm', 'mass': 1}]}")
            .replace('\'', '"')
            .getBytes(StandardCharsets.UTF_8);
    return new RunningProgram(
        ControllerOptions.headless()
            .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text), FILES))
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static String go(String height) {
    return "  movel(" + AT.formatted(height) + ", a=1.2, v=0.25)\n";
  }

  private static void run(RunningProgram program, String... lines) {
    program.run(
        "def f():\n  set_tcp(p[0, 0, 0.15, 0, 0, 0])\n  movej("
            + AT.formatted("0.2")
            + ", a=3, v=2)\n"
            + String.join("", lines)
            + "end\n");
  }

  private static Pose part(RunningProgram program) {
    return program.state().moved().getFirst().poseInBase();
  }

  @Test
  void fingersLiftItAndFeelItsWeight() throws Exception {
    RunningProgram program =
        cell(
            "{'type': 'gripper', 'name': 'g', 'close': 'tool_out[0]', 'gripped':"
                + " 'digital_in[2]', 'stroke': 0.08}");
    run(
        program,
        go("0.03"),
        GRIP,
        go("0.2"),
        "  sleep(1)\n  textmsg(get_standard_digital_in(2))\n  textmsg(norm(get_tcp_force()))\n");

    assertEquals("True", program.said().getFirst());
    assertEquals(9.82, Double.parseDouble(program.said().getLast()), 0.0982);
    assertEquals(0.17, part(program).z(), 0.002);
    assertEquals(0.35, part(program).x(), 0.002);
  }

  @Test
  void aCupLiftsIt() throws Exception {
    RunningProgram program =
        cell(
            "{'type': 'vacuum', 'name': 'v', 'suck': 'tool_out[0]', 'holds': 'digital_in[2]',"
                + " 'cup': {'force': 40}}");
    run(program, go("0.061"), GRIP, go("0.2"), "  textmsg(get_standard_digital_in(2))\n");

    assertEquals("True", program.said().getFirst());
    assertEquals(0.14, part(program).z(), 0.003);
  }

  @Test
  void aLightBarrierSeesItAndNotTheBallAroundIt() throws Exception {
    String barrier =
        "{'type': 'light-barrier', 'name': '%s', 'signal': 'digital_in[%d]', 'from': [0.2, -0.1,"
            + " %s], 'to': [0.6, -0.1, %s]}";
    RunningProgram program =
        cell(
            barrier.formatted("through", 3, "0.05", "0.05")
                + ","
                + barrier.formatted("above", 4, "0.075", "0.075"));
    run(program, "  textmsg(get_standard_digital_in(3), get_standard_digital_in(4))\n");

    assertTrue(program.said().getFirst().matches("True *False"), program.said().toString());
  }
}
