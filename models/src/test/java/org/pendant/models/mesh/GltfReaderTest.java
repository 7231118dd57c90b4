package org.pendant.models.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Base64;
import java.util.Random;
import org.junit.jupiter.api.Test;

class GltfReaderTest {
  private static final MeshNeighbours BESIDE = GltfReaderTest::resource;

  /** The corners of a tetrahedron along the axes, and its faces. */
  private static final float[] CORNERS = {0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3};

  private static final short[] FACES = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};

  /** The first part of a file: a node, a mesh, and where its numbers are. */
  private static final String FILE =
      """
      {
        "asset": {"version": "2.0"},
        "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
          {"type": "VEC3", "componentType": 5126, "bufferView": 0, "count": 4},
          {"type": "SCALAR", "componentType": 5123, "bufferView": 1, "count": 12}
        ],
        "bufferViews": [
          {"buffer": 0, "byteLength": 48},
          {"buffer": 0, "byteOffset": 48, "byteLength": 24}
        ],
        "buffers": [{"byteLength": 72%s}]
      }
      """;

  private static byte[] resource(String name) throws IOException {
    try (InputStream in = GltfReaderTest.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IOException("is not there");
      }
      return in.readAllBytes();
    }
  }

  private static byte[] numbers() {
    ByteBuffer bytes = ByteBuffer.allocate(72).order(ByteOrder.LITTLE_ENDIAN);
    for (float each : CORNERS) {
      bytes.putFloat(each);
    }
    for (short each : FACES) {
      bytes.putShort(each);
    }
    return bytes.array();
  }

  private static byte[] text(String json) {
    return json.getBytes(StandardCharsets.UTF_8);
  }

  /** A file with its numbers in it. */
  private static String gltf() {
    return FILE.formatted(
        ", \"uri\": \"data:application/octet-stream;base64,"
            + Base64.getEncoder().encodeToString(numbers())
            + "\"");
  }

  private static byte[] glb(String json, byte[] behind) {
    byte[] text = text(json + " ".repeat((4 - json.length() % 4) % 4));
    ByteBuffer file =
        ByteBuffer.allocate(28 + text.length + behind.length).order(ByteOrder.LITTLE_ENDIAN);
    file.putInt(0x46546C67).putInt(2).putInt(file.capacity());
    file.putInt(text.length).putInt(0x4E4F534A).put(text);
    file.putInt(behind.length).putInt(0x004E4942).put(behind);
    return file.array();
  }

  private static TriangleMesh read(byte[] bytes) throws MeshException {
    return MeshFile.read("a.gltf", bytes, MeshUnit.METRE, BESIDE);
  }

  private static String refusal(String json) {
    return assertThrows(MeshException.class, () -> read(text(json))).getMessage();
  }

  private static void requireBox(TriangleMesh mesh, double... leastAndMost) {
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(leastAndMost[axis], mesh.least(axis), 1e-6, "least " + axis);
      assertEquals(leastAndMost[3 + axis], mesh.most(axis), 1e-6, "most " + axis);
    }
  }

  @Test
  void filesOfAnotherProgramAreWhatItSaysOfThem() throws Exception {
    for (String name : new String[] {"two.glb", "two.gltf"}) {
      TriangleMesh mesh = MeshFile.read(name, resource(name), MeshUnit.METRE, BESIDE);

      assertEquals(60, mesh.triangles());
      assertEquals(0.0075, mesh.volumeM3(), 1e-8);
      // its y is up there, and z here
      requireBox(mesh, -0.05, -0.15, 0, 0.55, 0.15, 0.2);
    }
  }

  @Test
  void numbersAreInTheFileOrBehindIt() throws MeshException {
    TriangleMesh mesh = read(text(gltf()));

    assertEquals(1, mesh.volumeM3(), 1e-9);
    requireBox(mesh, 0, -3, 0, 1, 0, 2);
    assertEquals(mesh, read(glb(FILE.formatted(""), numbers())));
  }

  @Test
  void nodesShiftTurnScaleAndMirror() throws MeshException {
    String node = "{\"mesh\": 0, \"translation\": [0, 0, 1], \"scale\": [-2, 1, 1]}";
    requireBox(read(text(gltf().replace("{\"mesh\": 0}", node))), -2, -4, 0, 0, -1, 2);
    String turned = "{\"mesh\": 0, \"rotation\": [0, 0, 0.7071068, 0.7071068]}";
    requireBox(read(text(gltf().replace("{\"mesh\": 0}", turned))), -2, -3, 0, 0, 0, 1);
    String matrix = "{\"mesh\": 0, \"matrix\": [1,0,0,0, 0,1,0,0, 0,0,1,0, 5,6,0,1]}";
    requireBox(read(text(gltf().replace("{\"mesh\": 0}", matrix))), 5, -3, 6, 6, 0, 8);
  }

  @Test
  void aMeshThatIsThereTwiceIsTwoAlsoWhereOneIsMirrored() throws MeshException {
    String nodes =
        "{\"mesh\": 0}, {\"scale\": [-1, 1, 1], \"children\": [2]}, {\"mesh\": 0, \"translation\":"
            + " [1, 0, 0]}";
    TriangleMesh mesh = read(text(gltf().replace("{\"mesh\": 0}", nodes)));

    assertEquals(8, mesh.triangles());
    assertEquals(2, mesh.volumeM3(), 1e-9);
  }

  @Test
  void onlyTheSceneThatIsShownIsRead() throws MeshException {
    String file =
        gltf()
            .replace("{\"mesh\": 0}", "{\"mesh\": 0}, {\"mesh\": 0, \"translation\": [5, 0, 0]}")
            .replace(
                "\"nodes\":",
                "\"scene\": 1, \"scenes\": [{\"nodes\": [0]}, {\"nodes\": [1]}], \"nodes\":");

    requireBox(read(text(file)), 5, -3, 0, 6, 0, 2);
  }

  @Test
  void whatIsOutOfBoundsIsRefused() {
    assertEquals(
        "JSON:6:5: an accessor of 4 elements needs 48 bytes, its view has 40",
        refusal(gltf().replace("\"byteLength\": 48}", "\"byteLength\": 40}")));
    assertEquals(
        "JSON:7:5: an accessor of 12 elements needs 24 bytes, its view has 23",
        refusal(gltf().replace("\"byteOffset\": 48", "\"byteOffset\": 49")));
    assertEquals(
        "is cut: buffer 0 has 72 bytes, must have 73",
        refusal(gltf().replace("\"byteLength\": 72", "\"byteLength\": 73")));
    assertEquals(
        "JSON:7:61: bufferView is 7, must be 0 to 1",
        refusal(gltf().replace("\"bufferView\": 1", "\"bufferView\": 7")));
    assertEquals(
        "JSON:6:71: count is 1.0E9, must be 1 to 300000",
        refusal(gltf().replace("\"count\": 4", "\"count\": 1000000000")));
    byte[] wrong = numbers();
    wrong[48] = 9;
    assertEquals(
        "index 0 names point 9.0, 4 are there",
        assertThrows(MeshException.class, () -> read(glb(FILE.formatted(""), wrong))).getMessage());
  }

  @Test
  void nodesWithinThemselvesAreRefused() {
    assertEquals(
        "has no triangles, must have at least 4",
        refusal(gltf().replace("{\"mesh\": 0}", "{\"mesh\": 0, \"children\": [0]}")),
        "nothing shows it");
    assertEquals(
        "JSON:3:41: node 0 is in two others, or within itself",
        refusal(
            gltf()
                .replace("\"nodes\":", "\"scenes\": [{\"nodes\": [0]}], \"nodes\":")
                .replace("{\"mesh\": 0}", "{\"mesh\": 0, \"children\": [0]}")));
    StringBuilder chain = new StringBuilder("{\"children\": [1]}");
    for (int i = 2; i < 150; i++) {
      chain.append(", {\"children\": [").append(i).append("]}");
    }
    String deep = refusal(gltf().replace("{\"mesh\": 0}", chain + ", {\"mesh\": 0}"));
    assertTrue(deep.endsWith("more than 100 nodes within one another"), deep);
  }

  @Test
  void aMeshThatIsThereVeryOftenIsRefused() {
    String nodes = "{\"mesh\": 0}, ".repeat(9999) + "{\"mesh\": 0}";
    String points = "\"count\": 4096, \"byteOffset\": 0";
    byte[] large = Arrays.copyOf(numbers(), 49152 + 24);
    String file =
        FILE.formatted("")
            .replace("\"count\": 4", points)
            .replace("\"byteLength\": 48}", "\"byteLength\": 49152}")
            .replace("\"byteLength\": 72", "\"byteLength\": 49176")
            .replace("{\"mesh\": 0}", nodes);
    assertEquals(
        "has more than 1200000 points with repeated ones, must be at most that many: export it"
            + " coarser",
        assertThrows(MeshException.class, () -> read(glb(file, large))).getMessage());
  }

  @Test
  void extensionsThatHideTheShapeAreRefusedAndOthersAreNot() throws MeshException {
    String asset = "\"asset\":";
    assertEquals(
        "JSON:2:25: needs \"KHR_draco_mesh_compression\", which is not read: export it without"
            + " compression",
        refusal(
            gltf()
                .replace(
                    asset, "\"extensionsRequired\": [\"KHR_draco_mesh_compression\"], " + asset)));
    assertEquals(
        4,
        read(text(
                gltf()
                    .replace(asset, "\"extensionsRequired\": [\"KHR_materials_unlit\"], " + asset)))
            .triangles());
    assertEquals(
        "JSON:2:24: version is \"1.0\", must be 2.0",
        refusal(gltf().replace("\"2.0\"", "\"1.0\"")));
  }

  @Test
  void filesBesideAreReadAndOthersAreNot() {
    assertEquals(
        "JSON:13:41: none 1.bin: is not there",
        refusal(FILE.formatted(", \"uri\": \"none%201.bin\"")));
    assertEquals(
        "JSON:13:41: uri is \"a%2\", must have two digits behind each %",
        refusal(FILE.formatted(", \"uri\": \"a%2\"")));
    for (String uri : new String[] {"../a.bin", "/etc/passwd", "file:a", "a\\\\b", "%2e%2e/a"}) {
      String refusal = refusal(FILE.formatted(", \"uri\": \"" + uri + "\""));
      assertTrue(refusal.contains("must be a file beside this one, or below"), refusal);
    }
  }

  @Test
  void filesThatAreCutAreRefused() {
    byte[] file = glb(FILE.formatted(""), numbers());
    for (int length = 0; length < file.length; length++) {
      byte[] cut = Arrays.copyOf(file, length);

      assertThrows(MeshException.class, () -> read(cut));
    }
  }

  @Test
  void nothingElseHappensWithAnyBytes() {
    Random random = new Random(13);
    byte[][] files = {text(gltf()), glb(FILE.formatted(""), numbers())};
    for (int round = 0; round < 2000; round++) {
      byte[] file = files[round % 2].clone();
      for (int i = 0; i < 1 + round % 5; i++) {
        byte digit = (byte) ('0' + random.nextInt(10));
        file[random.nextInt(file.length)] = round % 3 == 0 ? digit : (byte) random.nextInt();
      }
      try {
        assertTrue(read(file).volumeM3() > 0);
      } catch (MeshException e) {
        assertTrue(e.getMessage().length() < 500, e.getMessage());
      }
    }
  }

  @Test
  void trianglesHaveTheBaseColourOfTheirMaterial() throws MeshException {
    String coloured =
        gltf()
            .replace("\"indices\": 1", "\"indices\": 1, \"material\": 0")
            .replace(
                "\"nodes\"",
                "\"materials\": [{\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 0.216, 0,"
                    + " 1]}}], \"nodes\"");
    assertEquals(0xFF8000, read(text(coloured)).rgb(0), "0.216 of the light is half on a screen");
    assertEquals(TriangleMesh.NO_COLOUR, read(text(gltf())).rgb(0));
  }

  @Test
  void aColourBeyondWhatThereIsIsRefused() {
    String wrong =
        gltf()
            .replace("\"indices\": 1", "\"indices\": 1, \"material\": 0")
            .replace(
                "\"nodes\"",
                "\"materials\": [{\"pbrMetallicRoughness\": {\"baseColorFactor\": [1, 2, 0, 1]}}],"
                    + " \"nodes\"");
    assertTrue(refusal(wrong).contains("baseColorFactor has 2.0"), refusal(wrong));
  }
}
