package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/** Meshes with a mass: the frame of their file and that of the body are not the same. */
final class MeshBodyTest {
  /** A block of 60 x 40 x 20 mm with a corner in the origin of its file. */
  private static final String BLOCK =
      """
      v 0 0 0
      v 60 0 0
      v 60 40 0
      v 0 40 0
      v 0 0 20
      v 60 0 20
      v 60 40 20
      v 0 40 20
      f 4 3 2 1
      f 5 6 7 8
      f 1 2 6 5
      f 2 3 7 6
      f 3 4 8 7
      f 4 1 5 8
      """;

  private static final String TABLE =
      "{\"type\": \"plane\", \"name\": \"table\", \"point\": [0, 0, 0], \"normal\": [0, 0, 1]},";

  @TempDir Path folder;

  @BeforeEach
  void writeBlock() throws IOException {
    Files.writeString(folder.resolve("block.obj"), BLOCK);
  }

  private static String mesh(String pose, String mass) {
    return "{\"type\": \"mesh\", \"name\": \"block\", \"pose\": ["
        + pose
        + "], \"mesh\": \"block.obj\", \"unit\": \"mm\", \"mass\": "
        + mass
        + "}";
  }

  private Scene read(String objects) throws JsonException {
    return SceneReader.read(
        "s.json",
        new ByteArrayInputStream(
            ("{\"objects\": [" + objects + "]}").getBytes(StandardCharsets.UTF_8)),
        MeshFiles.in(folder));
  }

  private static ContactWorld after(Scene scene, int frames) {
    ContactWorld world = new ContactWorld(scene);
    double[] away = new double[Transforms.SIZE];
    Transforms.of(new Pose(0, 0, 3, 0, 0, 0), away);
    for (int i = 0; i < frames; i++) {
      world.advance(away, new double[3], new double[6], 0.002);
    }
    return world;
  }

  private static void requirePose(Pose wanted, Pose found, double within) {
    for (int i = 0; i < Pose.SIZE; i++) {
      assertEquals(wanted.get(i), found.get(i), within, "pose[" + i + "]");
    }
  }

  @Test
  void aMassIsReadAndWritten() throws JsonException {
    Scene scene = read(mesh("0.4, 0, 0.5, 0.1, 0.2, 0.3", "1.5"));

    assertEquals(1.5, scene.objects().getFirst().massKg());
    byte[] text = SceneWriter.write(scene).getBytes(StandardCharsets.UTF_8);
    assertEquals(
        scene, SceneReader.read("t.json", new ByteArrayInputStream(text), MeshFiles.in(folder)));
  }

  @Test
  void itsPoseIsThatOfItsFileFromTheFirstFrame() throws JsonException {
    Pose pose = new Pose(0.4, 0.1, 0.5, 0.1, -0.7, 0.4);
    Scene scene = read(mesh("0.4, 0.1, 0.5, 0.1, -0.7, 0.4", "1"));
    ContactWorld world = new ContactWorld(scene);

    requirePose(pose, world.moved().getFirst().poseInBase(), 1e-12);
    double[] now = new double[Transforms.SIZE];
    assertTrue(world.poseNow(0, now));
    requirePose(pose, Transforms.toPose(now), 1e-12);
  }

  @Test
  void itTurnsAroundItsCentreOfGravityWhichFalls() throws JsonException {
    // lies over the edge of a box with the lesser part: it tips, and its centre goes down
    String box =
        "{\"type\": \"box\", \"name\": \"shelf\", \"pose\": [0, 0, 0.5, 0, 0, 0], \"size\": [0.1,"
            + " 0.1, 0.1]},";
    Scene scene = read(box + mesh("0.03, -0.02, 0.5501, 0, 0, 0", "1"));
    ContactWorld world = after(scene, 70);
    Pose pose = world.moved().getFirst().poseInBase();

    assertTrue(pose.ry() > 0.2, "it tips towards x: " + pose);
    ContactWorld held = after(read(box + mesh("0.015, -0.02, 0.5501, 0, 0, 0", "1")), 500);
    requirePose(new Pose(0.015, -0.02, 0.55, 0, 0, 0), held.moved().getFirst().poseInBase(), 5e-4);
  }

  @Test
  void itComesToRestOnTheTableWithTheOriginOfItsFileThere() throws JsonException {
    ContactWorld world = after(read(TABLE + mesh("0.4, 0, 0.1, 0, 0, 0.5", "1")), 1000);

    assertFalse(world.bodiesMove());
    requirePose(new Pose(0.4, 0, 0, 0, 0, 0.5), world.moved().getFirst().poseInBase(), 5e-4);
  }

  @Test
  void thePictureHasItWhereItIs() throws JsonException {
    Scene scene = read(TABLE + mesh("0.4, 0, 0.1, 0, 0, 0.5", "1"));
    ContactWorld world = after(scene, 1000);
    SceneObject.Mesh shown =
        (SceneObject.Mesh) MovedScene.of(scene, world.moved()).objects().getLast();

    assertEquals(world.moved().getFirst().poseInBase(), shown.poseInBase());
    assertEquals(0, shown.massKg());
  }

  @Test
  void copiesOfAPartHaveItsFrameToo() throws JsonException {
    Scene scene = read(TABLE + mesh("0.4, 0, 0.0001, 0, 0, 0.5", "1"));
    FreeBodies bodies =
        new FreeBodies(
            scene.objects(),
            List.of(
                new ArmBodies.Setup(new SceneTool(List.of(), List.of()), List.of(), Pose.ZERO)));
    PartPool pool = bodies.pool("block", 2).orElseThrow();

    assertFalse(pool.put(), "the first one is in the way");
    assertEquals(1, bodies.takeAway(new Vector3(0.3, -1, 0), new Vector3(0.5, 1, 1)));
    assertTrue(pool.put());
    assertEquals(1, bodies.takeAway(new Vector3(0.3, -1, 0), new Vector3(0.5, 1, 1)));
    assertTrue(pool.put());
    for (MovedObject each : bodies.moved(new ArmPlace(Pose.ZERO))) {
      if (each.there()) {
        requirePose(new Pose(0.4, 0, 0.0001, 0, 0, 0.5), each.poseInBase(), 1e-12);
      }
    }
  }

  @Test
  void whatCannotHaveAMassIsRefusedAtIt() throws IOException {
    Files.writeString(folder.resolve("block.obj"), BLOCK.replace(" 20\n", " 0.5\n"));
    assertEquals(
        "s.json:1:119: block.obj: length is 5.0E-4 m, must be 0.001 to 10 m; without a mass it"
            + " stands still",
        assertThrows(JsonException.class, () -> read(mesh("0, 0, 0, 0, 0, 0", "1"))).getMessage());
    assertEquals(
        "s.json:1:119: mass is 0 kg, must be 0.001 to 1000 kg",
        assertThrows(JsonException.class, () -> read(mesh("0, 0, 0, 0, 0, 0", "0"))).getMessage());
  }

  @Test
  void hullsThatOverlapAreRefused() {
    String refusal =
        assertThrows(JsonException.class, () -> read(TABLE + mesh("0, 0, -0.01, 0, 0, 0", "1")))
            .getMessage();

    assertEquals("s.json:1:13: bodies: block and table overlap by 10 mm", refusal);
  }
}
