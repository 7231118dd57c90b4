package org.pendant.controller.world;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;

final class SurfaceTest {
  /** Skin of the boxes here: the rounding of their edges. */
  private static final double SKIN_M = 0.001;

  private static final double ROOT_HALF = Math.sqrt(0.5);

  private final double[] normal = new double[3];

  /** Sides of 0.2, 0.4 and 0.6 m around (1, 2, 3). */
  private final Surface block = box(new Pose(1, 2, 3, 0, 0, 0), 0.2, 0.4, 0.6);

  private static Surface box(Pose pose, double x, double y, double z) {
    return Surface.of(new SceneObject.Box("box", pose, new Vector3(x, y, z), Material.DEFAULT));
  }

  private void assertSurface(
      Surface surface,
      double x,
      double y,
      double z,
      double distanceM,
      double nx,
      double ny,
      double nz) {
    double found = surface.distanceM(x, y, z, normal);
    assertAll(
        () -> assertEquals(distanceM, found, 1e-12, "distance"),
        () -> assertEquals(nx, normal[0], 1e-12, "normal x"),
        () -> assertEquals(ny, normal[1], 1e-12, "normal y"),
        () -> assertEquals(nz, normal[2], 1e-12, "normal z"));
  }

  @Test
  void planeIsSolidBehindItsNormal() {
    Surface table =
        Surface.of(
            new SceneObject.Plane(
                "table", new Vector3(5, 5, 0.1), new Vector3(0, 0, 7), Material.DEFAULT));
    assertSurface(table, 1, 2, 0.3, 0.2, 0, 0, 1);
    assertSurface(table, 1, 2, -0.1, -0.2, 0, 0, 1);
  }

  @Test
  void planeMayLean() {
    Surface slope =
        Surface.of(
            new SceneObject.Plane(
                "slope", new Vector3(0, 0, 0), new Vector3(1, 0, 1), Material.DEFAULT));
    assertSurface(slope, 1, 9, 1, Math.sqrt(2), ROOT_HALF, 0, ROOT_HALF);
  }

  @Test
  void ballPushesAwayFromItsCentre() {
    Surface ball =
        Surface.of(new SceneObject.Sphere("ball", new Vector3(1, 0, 0), 0.5, Material.DEFAULT));
    assertSurface(ball, 1, 0.8, 0, 0.3, 0, 1, 0);
    assertSurface(ball, 0.9, 0, 0, -0.4, -1, 0, 0);
  }

  @Test
  void centreOfABallIsLeftUpwards() {
    Surface ball =
        Surface.of(new SceneObject.Sphere("ball", new Vector3(1, 0, 0), 0.5, Material.DEFAULT));
    assertSurface(ball, 1, 0, 0, -0.5, 0, 0, 1);
  }

  @Test
  void eachFaceOfABoxPushesOutward() {
    assertSurface(block, 1.08, 2, 3, -0.02, 1, 0, 0);
    assertSurface(block, 0.92, 2, 3, -0.02, -1, 0, 0);
    assertSurface(block, 1, 2.19, 3, -0.01, 0, 1, 0);
    assertSurface(block, 1, 1.81, 3, -0.01, 0, -1, 0);
    assertSurface(block, 1, 2, 3.3, 0, 0, 0, 1);
    assertSurface(block, 1, 2, 2.69, 0.01, 0, 0, -1);
  }

  @Test
  void innerPointOfABoxIsPushedToTheNearestFace() {
    assertSurface(block, 1.01, 2.15, 3, -0.05, 0, 1, 0);
    assertSurface(block, 1.06, 2.15, 3, -0.04, 1, 0, 0);
  }

  @Test
  void centreOfABoxIsLeftThroughTheShortestWay() {
    assertSurface(block, 1, 2, 3, -0.1, 1, 0, 0);
  }

  @Test
  void edgeOfABoxIsRounded() {
    double late = SKIN_M * (Math.sqrt(2) - 1);
    assertSurface(block, 1.1, 2.2, 3, late, ROOT_HALF, ROOT_HALF, 0);
  }

  @Test
  void cornerOfABoxIsRounded() {
    double late = SKIN_M * (Math.sqrt(3) - 1);
    double third = Math.sqrt(1.0 / 3);
    assertSurface(block, 0.9, 2.2, 2.7, late, -third, third, -third);
  }

  @Test
  void thinSheetKeepsItsThicknessAndHasFineEdges() {
    Surface sheet = box(Pose.ZERO, 1, 1, 0.002);
    assertSurface(sheet, 0, 0, 0.0015, 0.0005, 0, 0, 1);
    assertSurface(sheet, 0.5, 0, 0.001, 0.0005 * (Math.sqrt(2) - 1), ROOT_HALF, 0, ROOT_HALF);
  }

  @Test
  void turnedBoxPushesAlongItsOwnAxes() {
    Surface turned = box(new Pose(0, 0, 0, 0, 0, Math.PI / 4), 0.2, 0.4, 0.6);
    assertSurface(turned, 0.09 * ROOT_HALF, 0.09 * ROOT_HALF, 0, -0.01, ROOT_HALF, ROOT_HALF, 0);
    assertSurface(turned, -0.19 * ROOT_HALF, 0.19 * ROOT_HALF, 0, -0.01, -ROOT_HALF, ROOT_HALF, 0);
  }

  @Test
  void normalTurnsSteadilyAroundAnEdge() {
    double[] before = new double[3];
    double corner = 0.1 - SKIN_M;
    block.distanceM(1.0995, 2, 3, before);
    for (int i = 0; i <= 1000; i++) {
      double angle = Math.PI / 2 * i / 1000;
      double x = 1 + corner + 0.5 * SKIN_M * Math.cos(angle);
      double y = 2 + 0.1 + corner + 0.5 * SKIN_M * Math.sin(angle);
      assertEquals(-0.5 * SKIN_M, block.distanceM(x, y, 3, normal), 1e-12);
      for (int k = 0; k < 3; k++) {
        assertEquals(before[k], normal[k], 0.002, "step " + i);
        before[k] = normal[k];
      }
    }
  }

  @Test
  void distanceNeverChangesFasterThanThePlace() {
    Random random = new Random(7);
    Surface turned = box(new Pose(0.1, -0.2, 0.3, 0.4, 1.1, -0.7), 0.1, 0.05, 0.2);
    for (int i = 0; i < 10_000; i++) {
      double x = 0.1 + random.nextGaussian() * 0.05;
      double y = -0.2 + random.nextGaussian() * 0.05;
      double z = 0.3 + random.nextGaussian() * 0.05;
      double step = 1e-4 * random.nextDouble();
      double here = turned.distanceM(x, y, z, normal);
      double along = normal[0];
      double there = turned.distanceM(x + step, y, z, normal);
      double length =
          Math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
      String place = x + " " + y + " " + z + " by " + step;
      assertEquals(1, length, 1e-12, place);
      assertTrue(Math.abs(there - here) <= step * (1 + 1e-9) + 1e-15, place);
      // between two places the slope is one of those at the ends, or between them
      double least = Math.min(along, normal[0]) * step - 1e-15;
      double most = Math.max(along, normal[0]) * step + 1e-15;
      assertTrue(there - here >= least - 1e-9 && there - here <= most + 1e-9, place);
    }
  }
}
