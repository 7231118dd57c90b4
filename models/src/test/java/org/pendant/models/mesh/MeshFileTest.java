package org.pendant.models.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Random;
import org.junit.jupiter.api.Test;

class MeshFileTest {
  private static final float[][] BOX = MeshTexts.box(100, 50, 20);

  private static TriangleMesh read(String name, byte[] bytes) throws MeshException {
    return MeshFile.read(name, bytes, MeshUnit.MILLIMETRE);
  }

  private static String refusal(String name, byte[] bytes) {
    return assertThrows(MeshException.class, () -> read(name, bytes)).getMessage();
  }

  private static String refusal(String name, String text) {
    return refusal(name, text.getBytes(StandardCharsets.US_ASCII));
  }

  @Test
  void threeFilesOfOneSolidAreTheSame() throws MeshException {
    Random random = new Random(5);
    for (int round = 0; round < 10; round++) {
      float[][] solid =
          MeshTexts.bumpy(random, 3 + random.nextInt(8), 3 + random.nextInt(9), 20 + 80 * round);

      TriangleMesh mesh = read("a.stl", MeshTexts.binaryStl(solid));

      assertEquals(mesh, read("b.STL", MeshTexts.textStl(solid)));
      assertEquals(mesh, read("c.obj", MeshTexts.obj(solid)));
      assertEquals(solid.length, mesh.triangles());
      // Euler: a surface without holes
      assertEquals(2 + mesh.triangles() / 2, mesh.points());
    }
  }

  @Test
  void unitsTellHowLargeSolidsAre() throws MeshException {
    byte[] file = MeshTexts.binaryStl(MeshTexts.box(4, 2, 1));
    for (MeshUnit unit : MeshUnit.values()) {
      TriangleMesh mesh = MeshFile.read("a.stl", file, unit);

      double length = unit.lengthM();
      assertEquals(4 * length, mesh.most(0) - mesh.least(0), 1e-12);
      assertEquals(8 * length * length * length, mesh.volumeM3(), 1e-9);
      assertEquals(unit, MeshUnit.of(unit.word()).orElseThrow());
    }
    assertTrue(MeshUnit.of("metre").isEmpty());
  }

  @Test
  void solidsThatAreInsideOutAreTurned() throws MeshException {
    float[][] turned =
        Arrays.stream(BOX)
            .map(t -> new float[] {t[0], t[1], t[2], t[6], t[7], t[8], t[3], t[4], t[5]})
            .toArray(float[][]::new);

    assertEquals(1e-4, read("a.stl", MeshTexts.binaryStl(turned)).volumeM3(), 1e-9);
  }

  /** The same triangles with each corner a little elsewhere, as if it were rounded by itself. */
  private static float[][] shaken(Random random, float[][] solid, double by) {
    return Arrays.stream(solid)
        .map(
            triangle -> {
              float[] moved = triangle.clone();
              for (int i = 0; i < moved.length; i++) {
                moved[i] += (float) (by * (2 * random.nextDouble() - 1));
              }
              return moved;
            })
        .toArray(float[][]::new);
  }

  @Test
  void cornersThatNearlyAreAtOnePlaceAreJoined() throws MeshException {
    Random random = new Random(21);
    for (double share : new double[] {2e-7, 2e-6, 2e-5}) {
      float[][] solid = MeshTexts.bumpy(random, 6, 8, 100);
      TriangleMesh wanted = read("a.stl", MeshTexts.binaryStl(solid));
      TriangleMesh found = read("a.stl", MeshTexts.textStl(shaken(random, solid, 200 * share)));

      assertEquals(wanted.triangles(), found.triangles());
      assertEquals(wanted.points(), found.points());
      assertEquals(wanted.volumeM3(), found.volumeM3(), 1e-3 * wanted.volumeM3());
    }
  }

  @Test
  void whatIsFartherApartIsAHoleAndItsPlaceIsTold() {
    float[][] solid = MeshTexts.bumpy(new Random(22), 6, 8, 100);
    String shaken =
        refusal("a.stl", MeshTexts.binaryStl(shaken(new Random(23), solid, 200 * 2e-3)));
    assertTrue(shaken.startsWith("is not closed: "), shaken);
    float[][] hole = shaken(new Random(24), Arrays.copyOf(solid, solid.length - 1), 1e-4);
    String open = refusal("a.stl", MeshTexts.binaryStl(hole));
    assertTrue(open.startsWith("is not closed: 3 edges have no triangle"), open);
  }

  @Test
  void whatIsClosedAsItIsKeepsItsSmallestParts() throws MeshException {
    float[][] tiny = MeshTexts.box(0.001f, 0.001f, 0.001f);
    float[][] both = Arrays.copyOf(BOX, BOX.length + tiny.length);
    for (int i = 0; i < tiny.length; i++) {
      both[BOX.length + i] = tiny[i].clone();
      for (int k = 0; k < 9; k += 3) {
        both[BOX.length + i][k] += 200;
      }
    }

    assertEquals(24, read("a.stl", MeshTexts.binaryStl(both)).triangles());
  }

  @Test
  void facesWithMoreCornersAreCutIntoTriangles() throws MeshException {
    String text =
        """
        v 0 0 0
        v 10 0 0
        v 10 10 0
        v 0 10 0
        v 5 5 10 1.0
        v 77 77 77
        f 4 3 2 1
        f 1 2 5
        f 2 3 5
        f 3 4 5
        f 4 1 5
        """;
    TriangleMesh mesh = read("a.obj", text.getBytes(StandardCharsets.US_ASCII));

    assertEquals(6, mesh.triangles());
    assertEquals(5, mesh.points(), "a point of no face is none");
    assertEquals(1e-6 / 3, mesh.volumeM3(), 1e-12);
  }

  @Test
  void binaryFilesAreRefusedWhereverTheyAreCut() {
    byte[] file = MeshTexts.binaryStl(BOX);
    for (int length = 0; length < file.length; length++) {
      String refusal = refusal("a.stl", Arrays.copyOf(file, length));

      assertTrue(refusal.startsWith("is cut: "), refusal);
    }
    assertEquals(
        "is no STL file: has 685 bytes, 12 triangles as its header tells need 684",
        refusal("a.stl", Arrays.copyOf(file, file.length + 1)));
  }

  @Test
  void textsAreRefusedWhereverTheyAreCut() {
    for (int lines = 1; lines < 86; lines++) {
      String text = new String(MeshTexts.textStl(BOX), StandardCharsets.US_ASCII);
      String cut = String.join("\n", Arrays.copyOf(text.split("\n"), lines));

      assertEquals("is cut: ends without endsolid", refusal("a.stl", cut + "\n"));
    }
    String obj = new String(MeshTexts.obj(BOX), StandardCharsets.US_ASCII);
    String refusal = refusal("a.obj", obj.substring(0, obj.lastIndexOf('f')));
    assertTrue(refusal.startsWith("is not closed: 3 edges have no triangle"), refusal);
    assertTrue(refusal.contains("from (100, 0, 20) to (100, 50, 20)"), refusal);
  }

  @Test
  void anyCoordinateThatIsNoNumberIsRefused() {
    for (int triangle = 0; triangle < BOX.length; triangle++) {
      for (int i = 0; i < 9; i++) {
        byte[] file = MeshTexts.binaryStl(BOX);
        float wrong = i % 2 == 0 ? Float.NaN : Float.NEGATIVE_INFINITY;
        ByteBuffer.wrap(file)
            .order(ByteOrder.LITTLE_ENDIAN)
            .putFloat(84 + 50 * triangle + 12 + 4 * i, wrong);

        assertEquals(
            "triangle " + (triangle + 1) + ": a coordinate is " + wrong + ", must be a number",
            refusal("a.stl", file));
      }
    }
  }

  @Test
  void whatIsNoSolidIsRefused() {
    assertEquals("has no triangles, must have at least 4", refusal("a.obj", ""));
    assertEquals("has no triangles, must have at least 4", refusal("a.stl", "solid\nendsolid\n"));
    assertEquals(
        "no triangle has an area", refusal("a.obj", "v 1 2 3\nv 1 2 3\nv 1 2 3\nf 1 2 3\n"));
    assertEquals(
        "fills no space, must be the surface of a solid",
        refusal("a.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nf 1 2 3\nf 3 2 1\n"));
    assertEquals(
        "is 100 m long, must be 0.001 to 10 m: is the unit right?",
        assertThrows(
                MeshException.class,
                () -> MeshFile.read("a.stl", MeshTexts.binaryStl(BOX), MeshUnit.METRE))
            .getMessage());
    assertEquals(
        "is no mesh that is known: must end with .stl, .obj, .glb or .gltf",
        refusal("a.step", "ISO"));
  }

  @Test
  void linesThatCannotBeReadAreTold() {
    assertEquals("line 2: has too few numbers", refusal("a.obj", "v 1 2 3\nv 1 2\n"));
    assertEquals("line 1: is \"x\", must be a number", refusal("a.obj", "v 1 x 3\n"));
    assertEquals(
        "line 2: point 2 is not there, 1 are so far", refusal("a.obj", "v 1 2 3\nf 1 2 3\n"));
    assertEquals("line 1: is \"a\", must be the number of a point", refusal("a.obj", "f a b c\n"));
    assertEquals(
        "line 1: a face has too few corners, must have at least 3", refusal("a.obj", "f 1 2\n"));
    assertEquals(
        "line 2: is \"vertex\", must be endsolid", refusal("a.stl", "solid\nvertex 1 2 3\n"));
  }

  @Test
  void largeFilesAreRefused() {
    assertEquals(
        "has more than 33554432 bytes, must be at most that many: export it coarser",
        refusal("a.stl", new byte[MeshFile.MAX_BYTES + 1]));
    assertEquals(
        "has 100001 triangles, must be at most 100000: export it coarser",
        refusal("a.stl", MeshTexts.binaryStl(new float[100_001][9])));
    assertEquals(
        "has more than 100000 triangles, must be at most 100000: export it coarser",
        refusal("a.obj", "v 1 2 3\nf" + " 1".repeat(100_003)));
  }

  @Test
  void nothingElseHappensWithAnyBytes() {
    Random random = new Random(9);
    byte[][] files = {MeshTexts.binaryStl(BOX), MeshTexts.textStl(BOX), MeshTexts.obj(BOX)};
    for (int round = 0; round < 600; round++) {
      byte[] file = files[round % 3].clone();
      for (int i = 0; i < 1 + round % 7; i++) {
        file[random.nextInt(file.length)] = (byte) random.nextInt();
      }
      try {
        TriangleMesh mesh = read(round % 3 == 2 ? "a.obj" : "a.stl", file);
        assertTrue(mesh.volumeM3() > 0);
      } catch (MeshException e) {
        assertTrue(e.getMessage().length() < 400, e.getMessage());
      }
    }
  }
}
