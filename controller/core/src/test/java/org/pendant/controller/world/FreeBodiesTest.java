package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

class FreeBodiesTest {
  private static final SceneObject TABLE =
      new SceneObject.Plane("table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT);
  private static final double[] NO_TCP = new double[3];
  private static final double[] STILL = new double[6];

  private final double[] now = new double[Transforms.SIZE];

  @Test
  void aBoxWithAMassFallsOnTheTableAndRests() {
    ContactWorld world = new ContactWorld(scene(List.of(TABLE, box(0, 0, 0.3, 1)), List.of()));
    advance(world, at(0, 0, 2), STILL, 1000);
    assertTrue(world.poseNow(1, now));
    assertEquals(0.05, now[11], 2e-4);
    assertFalse(world.bodiesMove());
    assertFalse(world.poseNow(0, now));
  }

  @Test
  void whereObjectsAreIsToldUntilTheyRest() {
    Scene scene = scene(List.of(TABLE, box(0, 0, 0.3, 1)), List.of());
    ContactWorld world = new ContactWorld(scene);
    String name = scene.objects().getLast().name();
    assertEquals(List.of(new MovedObject(name, new Pose(0, 0, 0.3, 0, 0, 0))), world.moved());
    for (int i = 0; i < 1000; i++) {
      advance(world, at(0, 0, 2), STILL, 1);
      var _ = world.moved();
    }
    List<MovedObject> rest = world.moved();
    assertEquals(0.05, rest.getFirst().poseInBase().z(), 2e-4);
    assertSame(rest, world.moved());
    SceneObject.Box there = (SceneObject.Box) MovedScene.of(scene, rest).objects().getLast();
    assertEquals(rest.getFirst().poseInBase(), there.poseInBase());
  }

  @Test
  void theToolFeelsTheWeightOfABoxThatRestsOnIt() {
    List<ToolPoint> points =
        List.of(
            new ToolPoint(new Vector3(0.03, 0.03, 0.1), 0.005),
            new ToolPoint(new Vector3(0.03, -0.03, 0.1), 0.005),
            new ToolPoint(new Vector3(-0.03, 0, 0.1), 0.005));
    ContactWorld world = new ContactWorld(scene(List.of(box(0.01, 0, 0.655, 1)), points));
    advance(world, at(0, 0, 0.5), STILL, 1000);
    double[] wrench = new double[6];
    world.wrench(at(0, 0, 0.5), NO_TCP, STILL, wrench);
    assertEquals(-9.82, wrench[2], 0.0982);
    assertEquals(0.01 * 9.82, wrench[4], 0.002);
    assertTrue(world.bodiesMove());
  }

  @Test
  void theToolPushesABoxOverTheTableAndFeelsItsFriction() {
    ContactWorld world =
        new ContactWorld(
            scene(
                List.of(TABLE, box(0, 0, 0.05, 2)),
                List.of(new ToolPoint(new Vector3(0, 0, 0), 0.01))));
    double[] wrench = new double[6];
    double[] twist = {0.1, 0, 0, 0, 0, 0};
    for (int i = 0; i < 1000; i++) {
      double[] flange = at(-0.061 + 0.1 * 0.002 * i, 0, 0.05);
      world.advance(flange, NO_TCP, twist, 0.002);
      world.wrench(flange, NO_TCP, twist, wrench);
    }
    world.poseNow(1, now);
    assertEquals(0.2, now[9], 0.002);
    // the tool also leans on the box by its own friction
    double pressed = 2 * 9.82 + wrench[2];
    assertEquals(-0.3 * pressed, wrench[0], 0.02 * 0.3 * pressed);
  }

  @Test
  void bodiesFallTowardsWhereTheBaseIsMounted() {
    ContactWorld world = new ContactWorld(scene(List.of(box(0, 0, 0.3, 1)), List.of()));
    world.setGravity(9.82, 0, 0);
    advance(world, at(0, 0, 2), STILL, 100);
    world.poseNow(0, now);
    assertEquals(0.5 * 9.82 * 0.2 * 0.2, now[9], 1e-3);
    assertEquals(0.3, now[11], 1e-9);
  }

  @Test
  void aMassIsReadAndWritten() throws JsonException {
    String file =
        """
        {
          "objects": [
            {"type": "box", "name": "part", "pose": [0, 0, 1, 0, 0, 0], "size": [0.1, 0.1, 0.1], "mass": 1.5},
            {"type": "sphere", "name": "ball", "centre": [1, 0, 1], "radius": 0.05, "mass": 0.2}
          ]
        }
        """;
    Scene scene = read(file);
    assertEquals(1.5, scene.objects().get(0).massKg());
    assertEquals(0.2, scene.objects().get(1).massKg());
    assertEquals(scene, read(SceneWriter.write(scene)));
  }

  @Test
  void aMassOutsideItsRangeAndBodiesThatOverlapAreRefusedWithTheirPlace() {
    String box =
        "{\"objects\": [{\"type\": \"plane\", \"name\": \"table\", \"point\": [0, 0, 0], "
            + "\"normal\": [0, 0, 1]}, {\"type\": \"box\", \"name\": \"part\", "
            + "\"pose\": [0, 0, 0.04, 0, 0, 0], \"size\": [0.1, 0.1, 0.1], \"mass\": %s}]}";
    assertEquals(
        "x.scene.json:1:187: mass is 0 kg, must be 0.001 to 1000 kg",
        assertThrows(JsonException.class, () -> read(box.formatted("0"))).getMessage());
    assertEquals(
        "x.scene.json:1:13: bodies: part and table overlap by 10 mm",
        assertThrows(JsonException.class, () -> read(box.formatted("1"))).getMessage());
  }

  private static Scene read(String json) throws JsonException {
    return SceneReader.read(
        "x.scene.json", new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)));
  }

  private static Scene scene(List<SceneObject> objects, List<ToolPoint> points) {
    return new Scene(objects, Optional.empty(), points);
  }

  private static SceneObject box(double x, double y, double z, double massKg) {
    return new SceneObject.Box(
        "part", new Pose(x, y, z, 0, 0, 0), new Vector3(0.1, 0.1, 0.1), Material.DEFAULT, massKg);
  }

  private static double[] at(double x, double y, double z) {
    return new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1, x, y, z};
  }

  private static void advance(ContactWorld world, double[] flange, double[] twist, int frames) {
    for (int i = 0; i < frames; i++) {
      world.advance(flange, NO_TCP, twist, 0.002);
    }
  }
}
