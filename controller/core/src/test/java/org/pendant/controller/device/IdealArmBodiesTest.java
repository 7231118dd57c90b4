package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;

/** The ideal arm pushes and carries objects with a mass, which do not move it. */
class IdealArmBodiesTest {
  private static final String START =
      "  set_tcp(p[0, 0, 0.15, 0, 0, 0])\n"
          + "  movej(p[0.4, -0.1, 0.2, 3.14159265, 0, 0], a=3, v=2)\n";

  private static final String GRIPPER =
      """
      {"type": "gripper", "name": "g", "close": "tool_out[0]", "gripped": "digital_in[2]",
       "stroke": 0.08}\
      """;

  private static RunningProgram cell(String devices) throws JsonException {
    byte[] text =
        """
        {"devices": [%s],
         "objects": [{"type": "plane", "name": "table", "point": [0, 0, 0], "normal": [0, 0, 1]},
          {"type": "box", "name": "part", "pose": [0.4, -0.1, 0.03, 0, 0, 0],
           "size": [0.1, 0.04, 0.06], "mass": 1}]}
        """
            .formatted(devices)
            .getBytes(StandardCharsets.UTF_8);
    return new RunningProgram(
        ControllerOptions.headless()
            .withArm(ArmChoice.IDEAL)
            .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
            .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text))));
  }

  private static String go(double x, double z) {
    return "  movel(p[%s, -0.1, %s, 3.14159265, 0, 0], a=1.2, v=0.25)%n".formatted(x, z);
  }

  private static void run(RunningProgram program, String... lines) {
    program.run("def f():\n" + START + String.join("", lines) + "end\n");
  }

  private static Pose part(RunningProgram program) {
    return program.state().moved().getFirst().poseInBase();
  }

  @Test
  void aGrippedPartIsLiftedAndWeighs() throws Exception {
    RunningProgram program = cell(GRIPPER);
    run(
        program,
        go(0.4, 0.03),
        "  set_tool_digital_out(0, True)\n  sleep(0.5)\n  textmsg(get_standard_digital_in(2))\n",
        go(0.4, 0.2),
        "  sleep(1)\n  textmsg(norm(get_tcp_force()))\n");
    assertEquals("True", program.said().getFirst());
    assertEquals(0.2, part(program).z(), 0.002);
    assertEquals(9.82, Double.parseDouble(program.said().getLast()), 0.0982);
  }

  @Test
  void aPushedPartSlidesAndTheArmStaysOnItsTarget() throws Exception {
    RunningProgram program = cell("");
    run(
        program,
        go(0.3, 0.2),
        go(0.3, 0.03),
        go(0.4, 0.03),
        "  textmsg(norm(get_joint_torques()))\n",
        "  textmsg(point_dist(get_actual_tcp_pose(), get_target_tcp_pose()))\n");
    assertTrue(part(program).x() > 0.44, () -> "is at " + part(program));
    assertEquals("0", program.said().getLast());
  }
}
