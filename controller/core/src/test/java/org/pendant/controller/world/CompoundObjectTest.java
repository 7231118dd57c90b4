package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.cell.BodyInertia;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** Objects that are put together of several solids. */
final class CompoundObjectTest {
  private static final String FLOOR =
      """
      {"type": "plane", "name": "floor", "point": [0, 0, 0], "normal": [0, 0, 1]}\
      """;

  /** An L of two boxes: a foot along x, and an upright at its end. */
  private static final String BRACKET =
      """
      {"type": "compound", "name": "bracket", "pose": [0.4, 0, 0, 0, 0, 0], "mass": 1.2, "parts": [
        {"type": "box", "pose": [0, 0, 0.01, 0, 0, 0], "size": [0.2, 0.05, 0.02]},
        {"type": "box", "name": "upright", "pose": [0.09, 0, 0.07, 0, 0, 0],
         "size": [0.02, 0.05, 0.1]}]}\
      """;

  /** A cup of a bottom and four walls, 0.1 m wide inside. */
  private static final String CUP =
      """
      {"type": "compound", "name": "cup", "pose": [0.5, 0, 0, 0, 0, 0], "density": 1000, "parts": [
        {"type": "box", "pose": [0, 0, 0.005, 0, 0, 0], "size": [0.12, 0.12, 0.01]},
        {"type": "box", "pose": [0.055, 0, 0.05, 0, 0, 0], "size": [0.01, 0.12, 0.08]},
        {"type": "box", "pose": [-0.055, 0, 0.05, 0, 0, 0], "size": [0.01, 0.12, 0.08]},
        {"type": "box", "pose": [0, 0.055, 0.05, 0, 0, 0], "size": [0.1, 0.01, 0.08]},
        {"type": "box", "pose": [0, -0.055, 0.05, 0, 0, 0], "size": [0.1, 0.01, 0.08]}]}\
      """;

  private static Scene scene(String... objects) throws JsonException {
    String text = "{\"objects\": [" + String.join(",\n", objects) + "]}";
    return SceneReader.read(
        "scene.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
  }

  private static SceneObject.Compound compound(String text) throws JsonException {
    return (SceneObject.Compound) scene(text).objects().getFirst();
  }

  private static FreeBodies bodies(Scene scene) {
    return new FreeBodies(
        scene.objects(), List.of(new ArmBodies.Setup(scene.tool(), List.of(), Pose.ZERO)));
  }

  private static void run(FreeBodies bodies, double timeS) {
    for (int i = 0; i < timeS / 0.002; i++) {
      bodies.advance(0.002);
    }
  }

  private static double[] pose(FreeBodies bodies, int object) {
    double[] pose12 = new double[Transforms.SIZE];
    bodies.pose(object, pose12);
    return pose12;
  }

  @Test
  void itsMassIsSpreadInItsPartsByTheirVolumes() throws Exception {
    SceneObject.Compound bracket = compound(BRACKET);
    assertEquals(1.2, bracket.massKg());
    assertEquals(0.8, bracket.partKg(0), 1e-12);
    assertEquals(0.4, bracket.partKg(1), 1e-12);
    assertEquals("part 1", bracket.parts().getFirst().name());
    assertEquals("upright", bracket.parts().getLast().name());
  }

  @Test
  void itsCentreOfGravityAndInertiaAreThoseOfItsPartsTogether() throws Exception {
    CompoundBody body = new CompoundBody(compound(BRACKET));
    Pose centre = body.ofFile(Pose.ZERO);
    double x = 0.4 * 0.09 / 1.2;
    double z = (0.8 * 0.01 + 0.4 * 0.07) / 1.2;
    assertEquals(x, centre.x(), 1e-12);
    assertEquals(z, centre.z(), 1e-12);
    double aboutY =
        0.8 * (0.2 * 0.2 + 0.02 * 0.02) / 12
            + 0.8 * (x * x + (z - 0.01) * (z - 0.01))
            + 0.4 * (0.02 * 0.02 + 0.1 * 0.1) / 12
            + 0.4 * ((0.09 - x) * (0.09 - x) + (0.07 - z) * (0.07 - z));
    double[] moments = BodyInertia.of(body.shape(), 1.2);
    assertEquals(aboutY, moments[1], 1e-12);
  }

  @Test
  void partsOfOneBoxWeighAndTurnAsItDoes() throws Exception {
    CompoundBody halves =
        new CompoundBody(
            compound(
                """
                {"type": "compound", "name": "b", "pose": [0, 0, 0, 0, 0, 0], "parts": [
                  {"type": "box", "pose": [0.05, 0, 0, 0, 0, 0], "size": [0.1, 0.06, 0.04],
                   "mass": 0.5},
                  {"type": "box", "pose": [-0.05, 0, 0, 0, 0, 3.14159265358979], "mass": 0.5,
                   "size": [0.1, 0.06, 0.04]}]}\
                """));
    double[] moments = BodyInertia.of(halves.shape(), 1);
    assertEquals((0.06 * 0.06 + 0.04 * 0.04) / 12, moments[0], 1e-12);
    assertEquals((0.2 * 0.2 + 0.04 * 0.04) / 12, moments[1], 1e-12);
    assertEquals((0.2 * 0.2 + 0.06 * 0.06) / 12, moments[2], 1e-12);
  }

  @Test
  void aDensityIsThatOfThePartsThatHaveIt() throws Exception {
    SceneObject.Compound weight =
        compound(
            """
            {"type": "compound", "name": "w", "pose": [0, 0, 0, 0, 0, 0], "parts": [
              {"type": "cylinder", "pose": [0, 0, 0.05, 0, 0, 0], "radius": 0.02, "length": 0.1,
               "density": 7850},
              {"type": "sphere", "centre": [0, 0, 0.12], "radius": 0.03, "mass": 0.05}]}\
            """);
    assertEquals(7850 * Math.PI * 0.02 * 0.02 * 0.1, weight.partKg(0), 1e-12);
    assertEquals(0.05, weight.partKg(1));
    assertEquals(weight.partKg(0) + 0.05, weight.massKg(), 1e-12);
  }

  @Test
  void anLStaysOnItsFootAndATallerOneFallsOnItsBack() throws Exception {
    FreeBodies stays = bodies(scene(FLOOR, BRACKET));
    run(stays, 2);
    assertEquals(0.4, pose(stays, 1)[9], 1e-4);
    assertEquals(0, pose(stays, 1)[11], 3e-4);
    assertEquals(1, pose(stays, 1)[8], 1e-5);
    String heavy =
        BRACKET
            .replace("\"mass\": 1.2, ", "")
            .replace("0.02]},", "0.02], \"mass\": 0.1},")
            .replace("[0.09, 0, 0.07", "[0.13, 0, 0.07")
            .replace("0.1]}]", "0.1], \"mass\": 3}]");
    FreeBodies falls = bodies(scene(FLOOR, heavy));
    run(falls, 2);
    assertTrue(pose(falls, 1)[8] < 0.5, () -> "z of its frame is " + pose(falls, 1)[8]);
  }

  @Test
  void aCupKeepsABallThatFallsIntoIt() throws Exception {
    String ball =
        """
        {"type": "sphere", "name": "ball", "centre": [0.52, 0.01, 0.2], "radius": 0.02,
         "mass": 0.1}\
        """;
    FreeBodies bodies = bodies(scene(FLOOR, CUP, ball));
    run(bodies, 2);
    double[] at = pose(bodies, 2);
    assertEquals(0.03, at[11], 5e-4);
    assertTrue(
        Math.abs(at[9] - 0.5) < 0.031 && Math.abs(at[10]) < 0.031, () -> at[9] + ", " + at[10]);
    assertEquals(0, pose(bodies, 1)[11], 5e-4);
  }

  @Test
  void oneThatStandsStillHasAHoleForTheTool() throws Exception {
    ContactWorld world = new ContactWorld(scene(CUP.replace("\"density\": 1000, ", "")));
    double[] wrench = new double[6];
    double[] flange = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0.5, 0, 0.03};
    world.wrench(flange, new double[3], new double[6], wrench);
    assertEquals(0.02, world.clearanceM(), 1e-9);
    flange[11] = 0.009;
    world.wrench(flange, new double[3], new double[6], wrench);
    assertEquals(40, wrench[2], 1);
    assertEquals("cup", world.contacts().getFirst().object());
  }

  @Test
  void runsRepeatToTheBit() throws Exception {
    List<List<Long>> all = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      FreeBodies bodies =
          bodies(
              scene(FLOOR, CUP, BRACKET.replace("[0.4, 0, 0, 0, 0, 0]", "[0.5, 0, 0.3, 1, 2, 0]")));
      List<Long> bits = new ArrayList<>();
      for (int step = 0; step < 500; step++) {
        bodies.advance(0.002);
        for (double each : pose(bodies, 2)) {
          bits.add(Double.doubleToRawLongBits(each));
        }
      }
      all.add(bits);
    }
    assertEquals(all.getFirst(), all.getLast());
  }

  @Test
  void whatIsWrittenIsReadAgain() throws Exception {
    Scene scene = scene(FLOOR, BRACKET, CUP.replace("[0.5, 0,", "[1, 0,"));
    String text = SceneWriter.write(scene);
    assertTrue(text.contains("\"parts\": [{\"type\": \"box\", \"pose\": [0, 0, 0.01"), text);
    assertTrue(text.contains("{\"type\": \"box\", \"name\": \"upright\""), text);
    assertEquals(
        scene,
        SceneReader.read(
            "again.json", new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8))));
  }

  private static void assertRefused(String message, String text) {
    assertEquals(message, assertThrows(JsonException.class, () -> scene(text)).getMessage());
  }

  private static String of(String members) {
    return "{\"type\": \"compound\", \"name\": \"c\", \"pose\": [0, 0, 0, 0, 0, 0],\n"
        + members
        + "}";
  }

  @Test
  void whatIsWrongWithItIsToldWithItsPlace() {
    String ball = "{\"type\": \"sphere\", \"centre\": [0, 0, 0], \"radius\": 0.01";
    assertRefused(
        "scene.json:1:14: key \"parts\" is missing, a compound must have it", of("\"mass\": 1"));
    assertRefused("scene.json:2:10: parts is empty, must have 1 to 32", of("\"parts\": []"));
    assertRefused(
        "scene.json:2:20: type is \"plane\", must be box, sphere, cylinder, capsule or mesh",
        of("\"parts\": [{\"type\": \"plane\"}]"));
    assertRefused(
        "scene.json:2:11: a part has a mass or a density, and the whole has one, must be one or the"
            + " other",
        of("\"parts\": [" + ball + ", \"mass\": 1}], \"mass\": 1"));
    assertRefused(
        "scene.json:3:1: a part has neither mass nor density, and others have: must be all or none",
        of("\"parts\": [" + ball + ", \"mass\": 1},\n" + ball + "}]"));
    assertRefused(
        "scene.json:2:78: density is 100 kg/m^3, with which it weighs 4.19E-4 kg, must be 0.001"
            + " to 1000 kg",
        of("\"parts\": [" + ball + ", \"density\": 100}]"));
    assertRefused(
        "scene.json:2:78: density is 0 kg/m^3, must be 1 to 25000 kg/m^3",
        of("\"parts\": [" + ball + ", \"density\": 0}]"));
    assertRefused(
        "scene.json:2:79: material is that of the whole, a part must have none",
        of("\"parts\": [" + ball + ", \"material\": {}}]"));
    assertRefused(
        "scene.json:2:80: density is there, and mass too, must be one or the other",
        of("\"parts\": [" + ball + "}], \"density\": 5, \"mass\": 1"));
  }
}
