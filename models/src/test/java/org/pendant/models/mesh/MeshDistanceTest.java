package org.pendant.models.mesh;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;

class MeshDistanceTest {
  private final Random random = new Random(11);
  private final double[] normal = new double[3];

  private static TriangleMesh mesh(float[][] triangles) throws MeshException {
    return MeshFile.read("a.stl", MeshTexts.binaryStl(triangles), MeshUnit.CENTIMETRE);
  }

  private double[] place(double withinM) {
    return new double[] {within(withinM), within(withinM), within(withinM)};
  }

  private double within(double most) {
    return most * (2 * random.nextDouble() - 1);
  }

  @Test
  void boxIsAsFarAsABox() throws MeshException {
    MeshDistance distance = new MeshDistance(mesh(MeshTexts.box(40, 30, 20)));
    for (int round = 0; round < 2000; round++) {
      double[] p = place(0.7);
      double x = Math.abs(p[0] - 0.2) - 0.2;
      double y = Math.abs(p[1] - 0.15) - 0.15;
      double z = Math.abs(p[2] - 0.1) - 0.1;
      double out = Math.hypot(Math.hypot(Math.max(x, 0), Math.max(y, 0)), Math.max(z, 0));
      double known = out > 0 ? out : Math.max(x, Math.max(y, z));

      assertEquals(known, distance.toPoint(p[0], p[1], p[2], normal), 1e-7);
      // along the normal the distance grows as fast as the way
      double farther =
          distance.toPoint(
              p[0] + 1e-4 * normal[0],
              p[1] + 1e-4 * normal[1],
              p[2] + 1e-4 * normal[2],
              new double[3]);
      assertEquals(known + 1e-4, farther, 1e-7);
    }
  }

  @Test
  void treeFindsWhatAllTrianglesTell() throws MeshException {
    TriangleMesh mesh = mesh(MeshTexts.bumpy(random, 24, 30, 40));
    MeshDistance distance = new MeshDistance(mesh);
    MeshLine line = new MeshLine(mesh);
    for (int round = 0; round < 300; round++) {
      double[] p = place(0.8);
      double nearest = nearestPoint(mesh, p);
      double found = distance.toPoint(p[0], p[1], p[2], normal);
      assertEquals(nearest, Math.abs(found), 1e-12);
      double[] end = {0, 0, 0};
      // the origin is inside, so a ray from outside goes in
      double[] in = {-p[0], -p[1], -p[2]};
      assertEquals(
          found > 0, line.meets(p, in) < 1, "inside is where rays to the middle meet none");
      assertTrue(line.apartM(p[0], p[1], p[2], end[0], end[1], end[2]) < 0);
    }
  }

  @Test
  void linesAreAsFarAsTheirNearestPoint() throws MeshException {
    TriangleMesh mesh = mesh(MeshTexts.bumpy(random, 12, 14, 30));
    MeshDistance distance = new MeshDistance(mesh);
    MeshLine line = new MeshLine(mesh);
    for (int round = 0; round < 200; round++) {
      double[] a = place(0.8);
      double[] b = place(0.8);
      double least = Double.POSITIVE_INFINITY;
      double step = Math.hypot(Math.hypot(b[0] - a[0], b[1] - a[1]), b[2] - a[2]) / 400;
      for (int i = 0; i <= 400; i++) {
        double share = i / 400.0;
        least =
            Math.min(
                least,
                distance.toPoint(
                    a[0] + share * (b[0] - a[0]),
                    a[1] + share * (b[1] - a[1]),
                    a[2] + share * (b[2] - a[2]),
                    normal));
      }
      double found = line.apartM(a[0], a[1], a[2], b[0], b[1], b[2]);
      // inside, the deepest point is looked for among some
      assertTrue(found <= (least > 0 ? least + step / 2 : 0.95 * least), found + " and " + least);
      assertTrue(found >= least - step, found + " and " + least);
    }
  }

  private static double nearestPoint(TriangleMesh mesh, double[] p) {
    double least = Double.POSITIVE_INFINITY;
    TrianglePoint point = new TrianglePoint();
    double[] corners = new double[9];
    for (int i = 0; i < mesh.triangles(); i++) {
      for (int k = 0; k < 9; k++) {
        corners[k] = mesh.coordinate(mesh.corner(i, k / 3), k % 3);
      }
      point.find(corners, 0, p[0], p[1], p[2]);
      least =
          Math.min(least, Math.hypot(Math.hypot(point.x - p[0], point.y - p[1]), point.z - p[2]));
    }
    return least;
  }
}
