package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneReader;
import org.pendant.controller.world.SceneWriter;
import org.pendant.models.json.JsonException;
import org.pendant.script.vm.ProgramState;

/** A tool with a shape and a mass of its own: it pushes, is felt, weighs, and stops the arm. */
@Tag("slow")
class ToolBodyProgramTest {
  /** A gripper of 200 mm, 100 mm wide, and a camera beside it. */
  private static final String TOOL =
      """
      "tool": [
        {"type": "box", "name": "gripper", "pose": [0, 0, 0.1, 0, 0, 0], "size": [0.1, 0.1, 0.2],
         "mass": 1.5},
        {"type": "cylinder", "name": "camera", "pose": [0.1, 0, 0.05, 0, 0, 0], "radius": 0.02,
         "length": 0.1, "mass": 0.5}
      ]\
      """;

  private static final String DECLARED =
      "set_target_payload(2, [0.025, 0, 0.0875])\nset_tcp(p[0, 0, 0.25, 0, 0, 0])\n";

  private static Scene scene(String members) throws JsonException {
    return SceneReader.read(
        "cell.json",
        new ByteArrayInputStream(("{" + members + "}").getBytes(StandardCharsets.UTF_8)));
  }

  private static RunningProgram run(ControllerOptions options, String text) {
    RunningProgram running = new RunningProgram(options);
    running.start(text);
    for (int i = 0; i < 10_000 && running.programState() == ProgramState.RUNNING; i++) {
      running.advance(1);
    }
    return running;
  }

  private static ControllerOptions in(String members) throws JsonException {
    return ControllerOptions.headless().withScene(scene(members));
  }

  @Test
  void itsMassesHangOnTheFlange() throws Exception {
    RunningProgram running =
        run(
            in(TOOL),
            "set_target_payload(0, [0, 0, 0])\n"
                + "sleep(0.1)\n"
                + "set_target_payload(2, [0.025, 0, 0.0875])\n"
                + "sleep(0.5)\n"
                + "textmsg(norm(get_tcp_force()) < 0.5)\n");
    assertEquals("True", running.said().getLast());
    assertTrue(
        running
            .reported()
            .toString()
            .contains(
                "the payload that is declared, 0 kg at [0, 0, 0] mm, is not that of the tool in"
                    + " the scene, 2 kg at [25, 0, 87.5] mm"),
        running.reported().toString());
  }

  @Test
  void theRightPayloadAndOneWithAPartAreNotTold() throws Exception {
    RunningProgram running =
        run(in(TOOL), DECLARED + "set_target_payload(3, [0, 0, 0.2])\nsleep(0.1)\n");
    assertFalse(
        running.reported().toString().contains("is declared"), running.reported().toString());
  }

  @Test
  void itsSideThatMeetsAPostIsAProtectiveStop() throws Exception {
    RunningProgram running =
        run(
            in(
                TOOL
                    + """
                    , "objects": [{"type": "box", "name": "post", "pose": [0.4, 0.2, 0.25, 0, 0, 0],
                      "size": [0.04, 0.04, 0.5]}]\
                    """),
            DECLARED
                + "movej(p[0.4, -0.1, 0.3, 3.14159265, 0, 0], a=3, v=2)\n"
                + "movel(p[0.4, 0.3, 0.3, 3.14159265, 0, 0], a=1.2, v=0.25)\n");
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    assertEquals(
        "the tool has hit \"post\"", running.state().safety().stop().orElseThrow().sentence());
    double y = running.state().arm().actualTcpInBase().y();
    assertEquals(0.13, y, 0.02, "the side of the gripper is 50 mm from its middle");
  }

  @Test
  void aPinBelowTheMiddleOfItsFaceIsMetToo() throws Exception {
    RunningProgram running =
        run(
            in(
                TOOL
                    + """
                    , "objects": [{"type": "cylinder", "name": "pin", "radius": 0.005, "length": 0.1,
                      "pose": [0.4, -0.1, 0.05, 0, 0, 0]}]\
                    """),
            "set_target_payload(2, [0.025, 0, 0.0875])\nset_tcp(p[0.04, 0, 0.25, 0, 0, 0])\n"
                + "movej(p[0.44, -0.1, 0.3, 3.14159265, 0, 0], a=3, v=2)\n"
                + "movel(p[0.44, -0.1, 0.0, 3.14159265, 0, 0], a=1.2, v=0.1)\n");
    assertEquals(
        "the tool has hit \"pin\"", running.state().safety().stop().orElseThrow().sentence());
  }

  @ParameterizedTest
  @EnumSource
  void itPushesWhatHasAMass(ArmChoice arm) throws Exception {
    RunningProgram running =
        run(
            in(TOOL
                    + """
                    , "objects": [
                    {"type": "plane", "name": "floor", "point": [0, 0, 0], "normal": [0, 0, 1]},
                    {"type": "box", "name": "part", "pose": [0.4, 0.1, 0.15, 0, 0, 0],
                      "size": [0.1, 0.1, 0.3], "mass": 2}]\
                    """)
                .withArm(arm),
            DECLARED
                + "movej(p[0.4, -0.1, 0.2, 3.14159265, 0, 0], a=3, v=2)\nzero_ftsensor()\n"
                + "movel(p[0.4, 0.1, 0.2, 3.14159265, 0, 0], a=1.2, v=0.05)\n");
    assertEquals(ProgramState.STOPPED, running.programState(), running.reported()::toString);
    double y = running.state().moved().getFirst().poseInBase().y();
    assertEquals(0.2, y, 0.01, "its side is 50 mm ahead, and the middle of the part 50 mm more");
  }

  @Test
  void aFileHasWhatWasWritten() throws Exception {
    Scene scene = scene(TOOL + ", \"links\": \"pass\"");
    assertEquals(2, scene.toolBodies().size());
    assertEquals(
        scene,
        SceneReader.read(
            "again.json",
            new ByteArrayInputStream(SceneWriter.write(scene).getBytes(StandardCharsets.UTF_8))));
  }

  @Test
  void inertiaIsThatOfTheBodiesTogether() throws Exception {
    Scene scene =
        scene(
            """
            "tool": [
              {"type": "sphere", "name": "a", "centre": [0.1, 0, 0], "radius": 0.01, "mass": 1},
              {"type": "sphere", "name": "b", "centre": [-0.1, 0, 0], "radius": 0.01, "mass": 1}
            ]\
            """);
    double own = 2 * 0.4 * 0.01 * 0.01;
    assertEquals(own, scene.mounted().orElseThrow().ixx(), 1e-12);
    assertEquals(own + 2 * 0.1 * 0.1, scene.mounted().orElseThrow().izz(), 1e-12);
  }

  @Test
  void whatCannotBeOnAFlangeIsToldWithItsPlace() {
    assertRefused(
        "\"tool\": [{\"type\": \"plane\", \"name\": \"p\", \"point\": [0, 0, 0], \"normal\": [0, 0,"
            + " 1]}]",
        "type is \"plane\", must be box, sphere, cylinder, capsule or mesh on the flange");
    assertRefused(
        TOOL.replace("camera", "gripper"),
        "name is \"gripper\" again, must be another for each body");
    assertRefused(
        TOOL + ", \"load\": {\"mass\": 1}",
        "load is there, and bodies of the tool have a mass, must be one or the other");
  }

  private static void assertRefused(String members, String what) {
    JsonException refusal = assertThrows(JsonException.class, () -> scene(members));
    assertTrue(
        refusal.getMessage().startsWith("cell.json:") && refusal.getMessage().contains(what),
        refusal.getMessage());
  }
}
