package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.EquipmentReader;
import org.pendant.controller.io.Signal;
import org.pendant.controller.world.SceneReader;
import org.pendant.models.json.JsonException;

/** A drawer that the arm pushes and pulls along its rail. */
@Tag("slow")
class RailDeviceTest {
  private static final String DRAWER =
      """
      {"devices": [{"type": "rail", "name": "drawer rail", "object": "drawer", "along": [0, 1, 0],
         "travel": 0.2, "friction": 10, "closed": "digital_in[0]", "opened": "digital_in[1]"}%s],
       "objects": [
         {"type": "box", "name": "drawer", "pose": [0.4, -0.1, 0.2, 0, 0, 0],
          "size": [0.3, 0.04, 0.1], "mass": 3},
         {"type": "box", "name": "door", "pose": [0.4, 2, 0.2, 0, 0, 0], "size": [0.1, 0.1, 0.1],
          "mass": 1}]}
      """;

  private static ControllerOptions options(String devices) throws JsonException {
    byte[] text = DRAWER.formatted(devices).getBytes(StandardCharsets.UTF_8);
    return ControllerOptions.headless()
        .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
        .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text)));
  }

  private static String go(double y, double speed) {
    return "movel(p[0.4, %s, 0.2, 3.14159265, 0, 0], a=0.5, v=%s)%n".formatted(y, speed);
  }

  private static double y(RunningProgram program) {
    return program.state().moved().getFirst().poseInBase().y();
  }

  @ParameterizedTest
  @EnumSource
  void theArmPushesADrawerOpenAndFeelsItsFriction(ArmChoice arm) throws Exception {
    RunningProgram program = new RunningProgram(options("").withArm(arm));
    program.run(
        "set_tcp(p[0, 0, 0.2, 0, 0, 0])\n"
            + "movej(p[0.4, -0.2, 0.2, 3.14159265, 0, 0], a=3, v=2)\nsleep(0.2)\n"
            + "textmsg(get_standard_digital_in(0))\nzero_ftsensor()\n"
            + go(0.0, 0.05)
            + "textmsg(get_standard_digital_in(0))\n"
            + go(0.0785, 0.05)
            + "textmsg(get_standard_digital_in(1))\n");
    assertEquals(List.of("True", "False", "True"), program.said());
    assertEquals(0.1, y(program), 0.001);
    assertEquals(0.2, program.state().moved().getFirst().poseInBase().z(), 1e-4);
  }

  @Test
  void aGripperPullsItOpen() throws Exception {
    RunningProgram program =
        new RunningProgram(
            options(
                ", {\"type\": \"gripper\", \"name\": \"g\", \"close\": \"tool_out[0]\","
                    + " \"gripped\": \"digital_in[2]\", \"stroke\": 0.08}"));
    program.run(
        "set_tcp(p[0, 0, 0.2, 0, 0, 0])\n"
            + "movej(p[0.4, -0.1, 0.4, 3.14159265, 0, 0], a=3, v=2)\n"
            + "movel(p[0.4, -0.1, 0.25, 3.14159265, 0, 0], a=0.5, v=0.2)\n"
            + "set_tool_digital_out(0, True)\nsleep(0.5)\ntextmsg(get_standard_digital_in(2))\n"
            + "movel(p[0.4, 0.05, 0.25, 3.14159265, 0, 0], a=0.5, v=0.1)\n"
            + "set_tool_digital_out(0, False)\nsleep(0.5)\n"
            + "movel(p[0.4, 0.05, 0.4, 3.14159265, 0, 0], a=0.5, v=0.2)\n");
    assertEquals(List.of("True"), program.said(), program.reported()::toString);
    assertEquals(0.05, y(program), 0.003);
    assertEquals(0.2, program.state().moved().getFirst().poseInBase().z(), 1e-3);
    assertTrue(program.state().devices().getFirst().on());
    assertFalse(program.state().io().level(Signal.named("digital_in[0]")));
  }

  @Test
  void whatIsWrongWithItIsToldWithItsPlace() {
    assertRefused("\"object\": \"wall\", \"along\": [1, 0, 0]", "an object with a mass");
    assertRefused(
        "\"object\": \"drawer\", \"along\": [1, 0, 0]", "which a rail or a door guides already");
    assertRefused("\"object\": \"door\", \"along\": [0, 0, 0]", "along is [0, 0, 0], must have a");
  }

  private static void assertRefused(String keys, String what) {
    String rail = ", {\"type\": \"rail\", " + keys + ", \"travel\": 0.1}";
    JsonException refusal = assertThrows(JsonException.class, () -> options(rail));
    assertTrue(refusal.getMessage().contains(what), refusal.getMessage());
  }
}
