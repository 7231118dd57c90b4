package org.pendant.motion.force;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

final class TaskAxesTest {
  private static final double[] REST = new double[6];

  private final TaskAxes axes = new TaskAxes();

  private void begin(FrameKind kind, Pose frame) {
    axes.begin(new ForceTask(kind, frame, Collections.nCopies(6, new ForceAxis(true, 1, 1))));
  }

  private static double[] tcp(double x, double y, double z) {
    double[] tcp = new double[Transforms.SIZE];
    Transforms.of(new Pose(x, y, z, 0, 0, 0), tcp);
    return tcp;
  }

  private double[] axis(int i) {
    double[] axis = new double[3];
    axes.add(i, 1, axis, 0);
    return axis;
  }

  private void is(int i, double x, double y, double z) {
    assertArrayEquals(new double[] {x, y, z}, axis(i), 1e-9);
  }

  @Test
  void typeTwoTakesTheFrameAsItIs() {
    begin(FrameKind.FIXED, new Pose(1, 2, 3, 0, 0, Math.PI / 2));
    axes.update(tcp(0, 0, 0), new double[] {1, 0, 0, 0, 0, 0});
    assertTrue(axes.known());
    is(0, 0, 1, 0);
    is(1, -1, 0, 0);
    is(2, 0, 0, 1);
  }

  @Test
  void typeOnePointsYAtTheOrigin() {
    begin(FrameKind.POINT, new Pose(1, 0, 0, 0, 0, 0));
    axes.update(tcp(0.5, 0, 0), REST);
    is(1, 1, 0, 0);
    is(0, 0, -1, 0);
    is(2, 0, 0, 1);
    axes.update(tcp(1, -0.5, 0), REST);
    is(1, 0, 1, 0);
    is(0, 1, 0, 0);
  }

  @Test
  void typeOneHasAxesWhereTheOriginIsAlongTheFramesZ() {
    begin(FrameKind.POINT, Pose.ZERO);
    axes.update(tcp(0, 0, 0.5), REST);
    is(1, 0, 0, -1);
    is(0, 1, 0, 0);
    is(2, 0, 1, 0);
  }

  @Test
  void typeOneKeepsItsAxesNearTheOrigin() {
    begin(FrameKind.POINT, Pose.ZERO);
    axes.update(tcp(0.5, 0, 0), REST);
    axes.update(tcp(0, 0.0099, 0), REST);
    is(1, -1, 0, 0);
  }

  @Test
  void typeThreePointsXAlongTheMotion() {
    begin(FrameKind.MOTION, Pose.ZERO);
    axes.update(tcp(0, 0, 0), REST);
    assertFalse(axes.known());
    axes.update(tcp(0, 0, 0), new double[] {0, -0.2, 5, 0, 0, 0});
    assertTrue(axes.known());
    is(0, 0, -1, 0);
    is(1, 1, 0, 0);
    is(2, 0, 0, 1);
    axes.update(tcp(0, 0, 0), REST);
    assertTrue(axes.known());
    is(0, 0, -1, 0);
  }

  @Test
  void screwDrivingTakesTheAxesOfTheTool() {
    begin(FrameKind.TOOL, Pose.ZERO);
    double[] tcp = new double[Transforms.SIZE];
    Transforms.of(new Pose(0, 0, 0, Math.PI, 0, 0), tcp);
    axes.update(tcp, REST);
    is(2, 0, 0, -1);
  }

  @Test
  void theAxesAreAlwaysAtRightAnglesAndRightHanded() {
    SplittableRandom random = new SplittableRandom(5);
    for (int i = 0; i < 2000; i++) {
      double[] n = random.doubles(12, -3, 3).toArray();
      begin(
          i % 2 == 0 ? FrameKind.POINT : FrameKind.MOTION,
          new Pose(n[0], n[1], n[2], n[3], n[4], n[5]));
      axes.update(tcp(n[6], n[7], n[8]), new double[] {n[9], n[10], n[11], 0, 0, 0});
      double[] x = axis(0);
      double[] y = axis(1);
      double[] z = axis(2);
      assertEquals(0, dot(x, y), 1e-9);
      assertEquals(1, dot(x, x), 1e-9);
      assertEquals(1, dot(y, y), 1e-9);
      double[] cross = {
        x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]
      };
      assertArrayEquals(z, cross, 1e-9);
    }
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
