package org.pendant.models.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

class ConvexHullTest {
  /** Points as one sees them from a frame somewhere: coordinates that are rounded. */
  static double[] elsewhere(Random random, double[] points) {
    double[] frame = new double[Transforms.SIZE];
    Transforms.of(
        new Pose(
            random.nextDouble(),
            random.nextDouble(),
            random.nextDouble(),
            3 * random.nextDouble(),
            3 * random.nextDouble(),
            3 * random.nextDouble()),
        frame);
    double[] moved = new double[points.length];
    for (int i = 0; i < points.length; i++) {
      int at = i - i % 3;
      int row = i % 3;
      moved[i] =
          frame[9 + row]
              + frame[3 * row] * points[at]
              + frame[3 * row + 1] * points[at + 1]
              + frame[3 * row + 2] * points[at + 2];
    }
    return moved;
  }

  private static void requireHull(ConvexHull hull, double[] points, double withinM) {
    assertEquals(2, hull.points() - hull.edges() + hull.faces(), "Euler: " + hull);
    for (int edge = 0; edge < hull.edges(); edge++) {
      assertTrue(hull.edge(edge, 2) != hull.edge(edge, 3), "a face on each side");
    }
    for (int face = 0; face < hull.faces(); face++) {
      for (int i = 0; i < points.length; i += 3) {
        double out = -hull.plane(face, 3);
        for (int axis = 0; axis < 3; axis++) {
          out += hull.plane(face, axis) * points[i + axis];
        }
        assertTrue(out <= withinM, "a point sticks out by " + out);
      }
      for (int corner = 0; corner < hull.corners(face); corner++) {
        double off = -hull.plane(face, 3);
        for (int axis = 0; axis < 3; axis++) {
          off += hull.plane(face, axis) * hull.coordinate(hull.corner(face, corner), axis);
        }
        assertEquals(0, off, 5e-5, "corners of a face are in its plane");
      }
    }
  }

  @Test
  void holdsAllPointsThatItIsAround() throws MeshException {
    Random random = new Random(3);
    for (int round = 0; round < 300; round++) {
      double[] points = new double[3 * (4 + random.nextInt(60))];
      for (int i = 0; i < points.length; i++) {
        // some on a coarse grid: many in one plane, on one line, at one place
        points[i] = round % 2 == 0 ? random.nextGaussian() / 3 : random.nextInt(4) / 4.0;
      }
      points[0] = 1;
      points[4] = 1;
      points[8] = 1;
      points[9] = 0;
      points[10] = 0;
      points[11] = 0;
      double[] seen = round % 3 == 0 ? points : elsewhere(random, points);
      requireHull(ConvexHull.of(seen), seen, 1e-4);
    }
  }

  @Test
  void facesOfABlockAreSixWhereverItStands() throws MeshException {
    Random random = new Random(4);
    for (int round = 0; round < 50; round++) {
      double[] corners = new double[3 * 60];
      for (int i = 0; i < 60; i++) {
        corners[3 * i] = (i & 1) * 0.3;
        corners[3 * i + 1] = i < 8 ? (i >> 1 & 1) * 0.2 : 0.2 * random.nextDouble();
        corners[3 * i + 2] = (i >> 2 & 1) * 0.1;
      }
      ConvexHull hull = ConvexHull.of(elsewhere(random, corners));

      assertEquals(6, hull.faces());
      assertTrue(hull.edges() >= 12 && hull.points() >= 8);
    }
  }

  @Test
  void aFineRoundBarKeepsItsRims() throws MeshException {
    double[] points = new double[2 * 3 * 60];
    for (int i = 0; i < 60; i++) {
      for (int end = 0; end < 2; end++) {
        points[6 * i + 3 * end] = 0.02 * Math.cos(Math.PI * i / 30);
        points[6 * i + 3 * end + 1] = 0.02 * Math.sin(Math.PI * i / 30);
        points[6 * i + 3 * end + 2] = 0.1 * end;
      }
    }
    ConvexHull hull = ConvexHull.of(elsewhere(new Random(5), points));

    assertEquals(62, hull.faces());
    assertEquals(120, hull.points());
  }

  @Test
  void blocksAndPrismsAreWhatTheirCornersSay() throws MeshException {
    for (ConvexHull made :
        new ConvexHull[] {ConvexHull.block(0.3, 0.2, 0.1), ConvexHull.prism(12, 0.1, 0.3)}) {
      double[] points = new double[3 * made.points()];
      for (int i = 0; i < points.length; i++) {
        points[i] = made.coordinate(i / 3, i % 3);
      }
      requireHull(made, points, 1e-12);
      ConvexHull found = ConvexHull.of(points);
      assertEquals(found.faces(), made.faces());
      assertEquals(found.surface().volumeM3(), made.surface().volumeM3(), 1e-12);
    }
  }

  @Test
  void ofVeryManyPointsThoseThatStickOutMostStay() throws MeshException {
    Random random = new Random(6);
    double[] points = new double[3 * 20_000];
    for (int i = 0; i < points.length; i += 3) {
      double x = random.nextGaussian();
      double y = random.nextGaussian();
      double z = random.nextGaussian();
      double length = Math.sqrt(x * x + y * y + z * z);
      points[i] = x / length;
      points[i + 1] = y / length;
      points[i + 2] = z / length;
    }
    ConvexHull hull = ConvexHull.of(points);

    assertEquals(ConvexHull.MAX_POINTS, hull.points());
    requireHull(hull, points, 0.04);
    assertEquals(2, hull.lengthM(0), 0.05);
  }

  @Test
  void itsSurfaceIsThatOfASolid() throws MeshException {
    Random random = new Random(7);
    float[][] solid = MeshTexts.bumpy(random, 8, 9, 50);
    TriangleMesh mesh = MeshFile.read("a.stl", MeshTexts.binaryStl(solid), MeshUnit.MILLIMETRE);
    TriangleMesh around = mesh.hull().surface();

    assertTrue(around.volumeM3() > mesh.volumeM3());
    MeshDistance distance = new MeshDistance(around);
    for (int i = 0; i < mesh.points(); i++) {
      double out =
          distance.toPoint(
              mesh.coordinate(i, 0), mesh.coordinate(i, 1), mesh.coordinate(i, 2), new double[3]);
      assertTrue(out < 5e-6, "point " + i + " is out by " + out);
    }
  }

  @Test
  void whatIsFlatIsRefused() {
    double[] square = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0.3, 0.3, 1e-9};
    assertEquals(
        "is flat, must be thick to be a solid",
        assertThrows(MeshException.class, () -> ConvexHull.of(square)).getMessage());
    double[] line = {0, 0, 0, 1, 0, 0, 0.5, 0, 0, 0.2, 0, 0};
    assertThrows(MeshException.class, () -> ConvexHull.of(line));
  }
}
