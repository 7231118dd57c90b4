package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
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
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.json.JsonException;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

final class MeshObjectTest {
  /** A block of 400 x 400 x 100 mm with its origin in the middle of its upper side. */
  private static final String BLOCK =
      """
      v -200 -200 -100
      v 200 -200 -100
      v 200 200 -100
      v -200 200 -100
      v -200 -200 0
      v 200 -200 0
      v 200 200 0
      v -200 200 0
      f 4 3 2 1
      f 5 6 7 8
      f 1 2 6 5
      f 2 3 7 6
      f 3 4 8 7
      f 4 1 5 8
      """;

  private static final String OBJECT =
      "{\"type\": \"mesh\", \"name\": \"block\", \"pose\": [0.4, 0, 0.1, 0, 0, 0],"
          + " \"mesh\": \"parts/block.obj\", \"unit\": \"mm\"}";

  @TempDir Path folder;

  @BeforeEach
  void writeBlock() throws IOException {
    Files.createDirectory(folder.resolve("parts"));
    Files.writeString(folder.resolve("parts/block.obj"), BLOCK);
  }

  private Scene read(String objects) throws JsonException {
    return SceneReader.read(
        "s.json",
        new ByteArrayInputStream(
            ("{\"objects\": [" + objects + "]}").getBytes(StandardCharsets.UTF_8)),
        MeshFiles.in(folder));
  }

  private String refusal(String object) {
    return assertThrows(JsonException.class, () -> read(object)).getMessage();
  }

  @Test
  void whatIsWrittenIsReadAgain() throws JsonException {
    Scene scene = read(OBJECT);
    byte[] text = SceneWriter.write(scene).getBytes(StandardCharsets.UTF_8);

    assertEquals(
        scene, SceneReader.read("t.json", new ByteArrayInputStream(text), MeshFiles.in(folder)));
    assertEquals(
        scene,
        SceneReader.read("t.json", new ByteArrayInputStream(text), MeshFiles.of(scene, List.of())));
  }

  @Test
  void unitMustBeSaid() {
    assertEquals(
        "s.json:1:14: unit is missing, must be mm, cm, m or in: a mesh does not say what its"
            + " numbers count",
        refusal(OBJECT.replace(", \"unit\": \"mm\"", "")));
    assertEquals(
        "s.json:1:115: unit is \"inch\", must be mm, cm, m or in",
        refusal(OBJECT.replace("\"mm\"", "\"inch\"")));
  }

  @Test
  void onlyFilesInTheFolderAreRead() throws IOException {
    for (String file : List.of("../block.obj", "/etc/block.obj", "a\\\\b.obj", "c:b.obj")) {
      String refusal = refusal(OBJECT.replace("parts/block.obj", file));
      assertTrue(refusal.contains("must be a file in the folder of the scene"), refusal);
    }
    Path outside = Files.createTempFile(folder.getParent(), "outside", ".obj");
    try {
      Files.createSymbolicLink(folder.resolve("link.obj"), outside);
      assertEquals(
          "s.json:1:88: link.obj: is a link that leads out of the folder of the scene",
          refusal(OBJECT.replace("parts/block.obj", "link.obj")));
    } finally {
      Files.delete(outside);
    }
  }

  @Test
  void whatIsWrongWithAFileIsTold() throws IOException {
    assertEquals(
        "s.json:1:88: none.stl: is not there",
        refusal(OBJECT.replace("parts/block.obj", "none.stl")));
    assertEquals(
        "s.json:1:88: mesh is \"part.step\", must end with .stl, .obj, .glb or .gltf",
        refusal(OBJECT.replace("parts/block.obj", "part.step")));
    Files.writeString(folder.resolve("parts/block.obj"), BLOCK.replace("f 5 6 7 8\n", ""));
    String open = refusal(OBJECT);
    assertTrue(open.startsWith("s.json:1:88: parts/block.obj: is not closed: 4 edges have"), open);
  }

  @Test
  void toolPressesAsOnABox() throws JsonException {
    SceneObject box =
        new SceneObject.Box(
            "block", new Pose(0.4, 0, 0.05, 0, 0, 0), new Vector3(0.4, 0.4, 0.1), Material.DEFAULT);
    List<ToolPoint> ball = List.of(new ToolPoint(new Vector3(0, 0, 0), 0.02));
    ContactWorld ofBox = new ContactWorld(new Scene(List.of(box), Optional.empty(), ball));
    ContactWorld ofMesh = new ContactWorld(read(OBJECT).withToolPoints(ball));
    double[] flange = new double[Transforms.SIZE];
    double[] twist = {0.1, 0.02, -0.05, 0, 0, 0};
    double[] wanted = new double[6];
    double[] found = new double[6];
    for (double x = 0.3; x < 0.5; x += 0.013) {
      Transforms.of(new Pose(x, 0.05, 0.117, 0, 0, 0), flange);
      ofBox.wrench(flange, new double[3], twist, wanted);
      ofMesh.wrench(flange, new double[3], twist, found);

      assertTrue(wanted[2] > 100, "the ball is 3 mm in it");
      assertArrayEquals(wanted, found, 1e-9);
    }
  }

  @Test
  void linksStopAtIt() throws JsonException {
    ArmDescription arm = ArmLibrary.load("ur5e");
    LinkCollisions links =
        LinkCollisions.of(arm, read(OBJECT.replace("[0.4, 0, 0.1", "[-0.5, 0, 0.2"))).orElseThrow();
    double[] up = {0, -Math.PI / 2, 0, 0, 0, 0};
    double[] down = {0, 0, 0, 0, 0, 0};

    assertTrue(links.look(up, false).isEmpty());
    LinkHit hit = links.look(down, false).orElseThrow();
    assertEquals("block", hit.other());
  }

  @Test
  void bodiesComeToRestOnIt() throws JsonException {
    Scene scene =
        read(
            OBJECT
                + ",{\"type\": \"box\", \"name\": \"box\", \"mass\": 1, \"size\": [0.1, 0.1, 0.1],"
                + " \"pose\": [0.4, 0.1, 0.16, 0, 0, 0.3]},"
                + "{\"type\": \"cylinder\", \"name\": \"can\", \"mass\": 1, \"radius\": 0.03,"
                + " \"length\": 0.1, \"pose\": [0.3, 0, 0.16, 0, 0, 0]},"
                + "{\"type\": \"capsule\", \"name\": \"pill\", \"mass\": 1, \"radius\": 0.03,"
                + " \"length\": 0.1, \"pose\": [0.5, -0.1, 0.14, 1.5707963, 0, 0]},"
                + "{\"type\": \"sphere\", \"name\": \"ball\", \"mass\": 1, \"radius\": 0.03,"
                + " \"centre\": [0.3, -0.1, 0.14]}");
    double[] heights = {0.15, 0.15, 0.13, 0.13};
    ContactWorld one = settled(scene);
    ContactWorld again = settled(scene);

    assertFalse(one.bodiesMove());
    for (int i = 0; i < heights.length; i++) {
      Pose pose = one.moved().get(i).poseInBase();
      assertEquals(heights[i], pose.z(), 3e-4, one.moved().get(i).name());
    }
    assertEquals(one.moved(), again.moved(), "the same in every run");
  }

  private static ContactWorld settled(Scene scene) {
    ContactWorld world = new ContactWorld(scene);
    double[] away = new double[Transforms.SIZE];
    Transforms.of(new Pose(0, 0, 3, 0, 0, 0), away);
    for (int i = 0; i < 1000; i++) {
      world.advance(away, new double[3], new double[6], 0.002);
    }
    return world;
  }
}
