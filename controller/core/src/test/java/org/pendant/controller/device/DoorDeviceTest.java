package org.pendant.controller.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
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
import org.pendant.script.vm.ProgramState;

/** Doors that move an object of the scene. */
@Tag("slow")
class DoorDeviceTest {
  private static final String SLIDES = "\"object\": \"leaf\", \"slides\": [0, -0.4, 0]";
  private static final String TURNS =
      "\"object\": \"leaf\", \"hinge\": [0.4, 0.5, 0.3], \"turns\": [0, 0, -1.5]";

  /** A leaf across x, in front of which parts may be. */
  private static final String CELL =
      """
      {"devices": [{"type": "door", "close": "digital_out[0]", "closed": "digital_in[0]",
         "opened": "digital_in[1]", "time": 1, %s}],
       "objects": [{"type": "box", "name": "leaf", "pose": [0.4, 0.4, 0.3, 0, 0, 0],
         "size": [0.02, 0.2, 0.3], "mass": 4}%s]}
      """;

  private static final String SHUT =
      """
      sleep(0.1)
      textmsg(get_standard_digital_in(1))
      set_standard_digital_out(0, True)
      sleep(%s)
      textmsg(get_standard_digital_in(0))
      """;

  private static ControllerOptions options(String door, String objects) throws JsonException {
    byte[] text = CELL.formatted(door, objects).getBytes(StandardCharsets.UTF_8);
    return ControllerOptions.headless()
        .withScene(SceneReader.read("cell.json", new ByteArrayInputStream(text)))
        .withEquipment(EquipmentReader.read("cell.json", new ByteArrayInputStream(text)));
  }

  private static Pose pose(RunningProgram program, int object) {
    return program.state().moved().get(object).poseInBase();
  }

  private static DeviceState door(RunningProgram program) {
    return program.state().devices().getFirst();
  }

  @ParameterizedTest
  @EnumSource
  void aDoorSlidesShutAndOpenInItsTime(ArmChoice arm) throws Exception {
    RunningProgram program = new RunningProgram(options(SLIDES, "").withArm(arm));
    program.run(SHUT.formatted(0.97));
    assertEquals(List.of("True", "False"), program.said());
    program.advance(15);
    assertEquals(0, door(program).openingM());
    assertEquals(0, pose(program, 0).y(), 0.001);
    assertEquals(0.3, pose(program, 0).z(), 1e-5);
    program.run("set_standard_digital_out(0, False)\nsleep(0.5)\n");
    assertEquals(0.5, door(program).openingM(), 0.02);
    assertEquals(0.2, pose(program, 0).y(), 0.008);
    program.advance(280);
    assertEquals(1, door(program).openingM());
  }

  @Test
  void aDoorTurnsAboutItsHinge() throws Exception {
    RunningProgram program = new RunningProgram(options(TURNS, ""));
    program.run(SHUT.formatted(1.02));
    assertEquals(List.of("True", "True"), program.said());
    Pose shut = pose(program, 0);
    assertEquals(0.4 - 0.1 * Math.sin(1.5), shut.x(), 0.001);
    assertEquals(0.5 - 0.1 * Math.cos(1.5), shut.y(), 0.001);
    assertEquals(-1.5, shut.rz(), 0.006);
  }

  @Test
  void aDoorThatIsLiftedHoldsItsWeight() throws Exception {
    RunningProgram program =
        new RunningProgram(options("\"object\": \"leaf\", \"slides\": [0, 0, 0.3]", ""));
    program.run(SHUT.formatted(3));
    assertEquals(List.of("True", "True"), program.said());
    assertEquals(0.6, pose(program, 0).z(), 0.001);
  }

  @Test
  void whatStandsInItsWayHoldsItUntilItOpensAgain() throws Exception {
    String post =
        """
        , {"type": "cylinder", "name": "post", "pose": [0.4, 0.1, 0.3, 0, 0, 0], "radius": 0.02,
           "length": 0.3}\
        """;
    RunningProgram program = new RunningProgram(options(SLIDES, post));
    program.run(SHUT.formatted(3));
    assertEquals(List.of("True", "False"), program.said());
    assertEquals(0.22, pose(program, 0).y(), 0.002);
    assertEquals(0.55, door(program).openingM(), 0.01);
    program.run(
        "set_standard_digital_out(0, False)\nsleep(1)\ntextmsg(get_standard_digital_in(1))\n");
    assertEquals("True", program.said().getLast());
  }

  @Test
  void itPushesAPartOutOfItsWay() throws Exception {
    String part =
        """
        , {"type": "box", "name": "shelf", "pose": [0.4, 0, 0.1, 0, 0, 0], "size": [0.2, 1, 0.04]}
        , {"type": "box", "name": "part", "pose": [0.4, 0.2, 0.17, 0, 0, 0],
           "size": [0.1, 0.1, 0.1], "mass": 1}\
        """;
    RunningProgram program = new RunningProgram(options(SLIDES, part));
    program.run(SHUT.formatted(1.5));
    assertEquals(List.of("True", "True"), program.said());
    assertTrue(pose(program, 1).y() < -0.14, pose(program, 1)::toString);
  }

  @Test
  void aShutDoorStopsTheArmThatDrivesIntoIt() throws Exception {
    RunningProgram program = new RunningProgram(options(SLIDES, ""));
    program.start(
        "set_tcp(p[0, 0, 0.1, 0, 0, 0])\nset_standard_digital_out(0, True)\n"
            + "movej(p[0.55, 0, 0.3, 3.14159265, 0, 0], a=3, v=2)\nsleep(1)\n"
            + "movel(p[0.25, 0, 0.3, 3.14159265, 0, 0], a=1, v=0.1)\n");
    program.finish();
    assertEquals(ProgramState.PAUSED, program.programState(), program.reported()::toString);
    assertTrue(
        program.reported().stream().anyMatch(each -> each.contains("protective stop")),
        program.reported()::toString);
    assertEquals(0.4, pose(program, 0).x(), 0.002);
  }

  @Test
  void runsWithADoorRepeatToTheBit() throws Exception {
    List<List<Long>> bits = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      RunningProgram program = new RunningProgram(options(TURNS, ""));
      program.start(SHUT.formatted(2));
      List<Long> run = new ArrayList<>();
      for (int frame = 0; frame < 800; frame++) {
        program.advance(1);
        for (double each : pose(program, 0).toArray()) {
          run.add(Double.doubleToRawLongBits(each));
        }
      }
      bits.add(run);
    }
    assertEquals(bits.getFirst(), bits.getLast());
  }

  @Test
  void whatIsWrongWithItIsToldWithItsPlace() {
    assertRefused("\"object\": \"wall\", \"slides\": [1, 0, 0]", "an object with a mass");
    assertRefused("\"object\": \"leaf\"", "must have slides or turns, has none");
    assertRefused(SLIDES + ", \"turns\": [0, 0, 1]", "must have slides or turns, has both");
    assertRefused(SLIDES + ", \"hinge\": [0, 0, 1]", "hinge is there, and the door slides");
    assertRefused("\"object\": \"leaf\", \"turns\": [0, 0, 1]", "key \"hinge\" is missing");
    assertRefused(
        "\"object\": \"leaf\", \"hinge\": [0, 0, 0], \"turns\": [0, 3, 1]",
        "turns is [0, 3, 1], must have a length of at least 0.001 and at most 3");
    assertRefused(TURNS + ", \"force\": 7", "force is there, and the door turns");
    assertRefused("\"slides\": [1, 0, 0]", "slides is there, and no object that it is of");
    assertRefused(
        SLIDES
            + "}, {\"type\": \"rail\", \"object\": \"leaf\", \"along\": [1, 0, 0],"
            + " \"travel\": 1",
        "which a rail or a door guides already");
  }

  private static void assertRefused(String keys, String what) {
    JsonException refusal = assertThrows(JsonException.class, () -> options(keys, ""));
    assertTrue(refusal.getMessage().contains(what), refusal.getMessage());
  }
}
