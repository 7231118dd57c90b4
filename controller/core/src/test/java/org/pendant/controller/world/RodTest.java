package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.models.collision.SolidShape;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** Cylinders and capsules, and what bounces. */
class RodTest {
  private static final SceneObject TABLE =
      new SceneObject.Plane("table", new Vector3(0, 0, 0), new Vector3(0, 0, 1), Material.DEFAULT);

  private static SceneObject.Rod rod(boolean capsule, Pose pose, double massKg) {
    return new SceneObject.Rod("rod", pose, 0.05, 0.2, capsule, Material.DEFAULT, massKg);
  }

  /** Rods that lie along the base's y, their middles 1 m up. */
  @ParameterizedTest
  @CsvSource({
    "true, 0, 0, 1.06, 0.01, 0, 0, 1",
    "true, 0, 0.2, 1, 0.05, 0, 1, 0",
    "true, 0, -0.06, 1.02, -0.03, 0, 0, 1",
    "false, 0.07, 0.05, 1, 0.02, 1, 0, 0",
    "false, 0.02, 0.11, 1, 0.01, 0, 1, 0",
    "false, 0, -0.09, 1, -0.01, 0, -1, 0",
    "false, 0, 0, 0.96, -0.01, 0, 0, -1"
  })
  void theDistanceOfAPointAndTheWayOut(
      boolean capsule,
      double x,
      double y,
      double z,
      double distance,
      double nx,
      double ny,
      double nz) {
    Surface surface = Surface.of(rod(capsule, new Pose(0, 0, 1, -Math.PI / 2, 0, 0), 0));
    double[] normal = new double[3];
    assertEquals(distance, surface.distanceM(x, y, z, normal), 1e-12);
    assertEquals(nx, normal[0], 1e-12);
    assertEquals(ny, normal[1], 1e-12);
    assertEquals(nz, normal[2], 1e-12);
  }

  @ParameterizedTest
  @CsvSource({"true, 0.05", "false, 0.10"})
  void theDistanceOfALineIsThatOfItsNearestPoint(boolean capsule, double distance) {
    SolidShape rod = new SolidShape.Rod(new Pose(0, 0, 0.1, 0, 0, 0), 0.05, 0.2, capsule);
    assertEquals(distance, rod.toSegment(-1, 0, 0.3, 1, 0, 0.3), 1e-9);
    assertEquals(0.02, rod.toSegment(0.07, -1, 0.1, 0.07, 1, 0.1), 1e-9);
    assertEquals(-0.05, rod.toSegment(-1, 0, 0.1, 1, 0, 0.1), 1e-6);
  }

  @Test
  void aCylinderLandsOnItsEndAndACapsuleRollsOnItsSide() {
    assertEquals(0.1, height(rod(false, new Pose(0, 0, 0.15, 0, 0, 0), 1)), 5e-4);
    assertEquals(0.05, height(rod(true, new Pose(0, 0, 0.1, 1.5, 0, 0), 1)), 5e-4);
  }

  private static double height(SceneObject object) {
    ContactWorld world =
        new ContactWorld(new Scene(List.of(TABLE, object), Optional.empty(), List.of()));
    advance(world, 1000);
    return world.moved().getFirst().poseInBase().z();
  }

  @Test
  void aBallComesBackAsItsRestitutionSays() {
    SceneObject ball =
        new SceneObject.Sphere(
            "ball", new Vector3(0, 0, 0.55), 0.05, new Material(4e4, 0.2, 0.3, 0.8), 1);
    ContactWorld world =
        new ContactWorld(new Scene(List.of(TABLE, ball), Optional.empty(), List.of()));
    advance(world, 160);
    double highest = 0;
    for (int i = 0; i < 260; i++) {
      advance(world, 1);
      highest = Math.max(highest, world.moved().getFirst().poseInBase().z());
    }
    assertEquals(0.05 + 0.64 * 0.5, highest, 0.01);
  }

  @Test
  void rodsAndRestitutionAreReadAndWritten() throws JsonException {
    Scene scene =
        read(
            """
            {"objects": [
              {"type": "cylinder", "name": "peg", "pose": [0, 0, 1, 0, 0, 0], "radius": 0.01,
                "length": 0.05, "mass": 0.1, "material": {"restitution": 0.4}},
              {"type": "capsule", "name": "pill", "pose": [1, 0, 1, 0, 0, 0], "radius": 0.01,
                "length": 0.05}
            ]}
            """);
    SceneObject.Rod peg = (SceneObject.Rod) scene.objects().getFirst();
    assertEquals(0.4, peg.material().restitution());
    assertEquals("cylinder", peg.type());
    assertEquals(scene, read(SceneWriter.write(scene)));
  }

  @Test
  void aRestitutionThatWouldMakeEnergyIsRefused() {
    JsonException refused =
        assertThrows(
            JsonException.class,
            () ->
                read(
                    "{\"objects\": [{\"type\": \"plane\", \"name\": \"a\", \"point\": [0, 0, 0],"
                        + " \"normal\": [0, 0, 1], \"material\": {\"restitution\": 1.1}}]}"));
    assertEquals("x.json:1:114: restitution is 1.1, must be 0 to 1", refused.getMessage());
  }

  private static Scene read(String json) throws JsonException {
    return SceneReader.read(
        "x.json", new ByteArrayInputStream(json.getBytes(StandardCharsets.UTF_8)));
  }

  private static void advance(ContactWorld world, int frames) {
    double[] away = new double[Transforms.SIZE];
    Transforms.of(new Pose(3, 3, 3, 0, 0, 0), away);
    for (int i = 0; i < frames; i++) {
      world.advance(away, new double[3], new double[6], 0.002);
    }
  }
}
