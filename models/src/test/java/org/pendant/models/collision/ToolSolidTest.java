package org.pendant.models.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

class ToolSolidTest {
  private static final ToolSolid BLOCK =
      new ToolSolid(new SolidShape.Block(new Pose(0, 0, 0.1, 0, 0, 0), 0.1, 0.1, 0.2));

  private static double[] at(double x, double y, double z, double rx) {
    double[] flange12 = new double[Transforms.SIZE];
    Transforms.of(new Pose(x, y, z, rx, 0, 0), flange12);
    return flange12;
  }

  @Test
  void aBlockIsAsFarFromAFloorAsItsLowestCorner() {
    SolidShape floor = new SolidShape.HalfSpace(0, 0, 0, 0, 0, 1);
    assertEquals(0.3, BLOCK.toObstacle(at(0, 0, 0.5, Math.PI), floor), 1e-12);
    assertEquals(-0.05, BLOCK.toObstacle(at(0, 0, 0.15, Math.PI), floor), 1e-12);
    assertEquals(0.45, BLOCK.toObstacle(at(0, 0, 0.5, Math.PI / 2), floor), 1e-12);
  }

  @Test
  void aPinThatEndsBelowTheMiddleOfAFaceIsSeen() {
    SolidShape pin = new SolidShape.Rod(new Pose(0, 0, 0.05, 0, 0, 0), 0.004, 0.1, false);
    assertEquals(0.1, BLOCK.toObstacle(at(0, 0, 0.4, Math.PI), pin), 1e-4);
    assertTrue(BLOCK.toObstacle(at(0, 0, 0.29, Math.PI), pin) < 0);
  }

  @Test
  void aBallIsAsFarAsItsSurface() {
    ToolSolid ball = new ToolSolid(new SolidShape.Ball(0, 0, 0.1, 0.03));
    SolidShape other = new SolidShape.Ball(0, 0, 0, 0.05);
    assertEquals(0.02, ball.toObstacle(at(0, 0, 0, 0), other), 1e-12);
    double[] line = {-1, 0, 0.2, 1, 0, 0.2};
    assertEquals(0.07, ball.toSegment(at(0, 0, 0, 0), line, 0), 1e-12);
  }

  @Test
  void itReachesAsFarAsItsFarthestCorner() {
    assertEquals(Math.sqrt(0.05 * 0.05 * 2 + 0.2 * 0.2), BLOCK.extentM(new double[3], 0), 1e-12);
    assertEquals(Math.sqrt(0.05 * 0.05 * 2 + 0.1 * 0.1), BLOCK.reachM(), 1e-12);
  }

  @Test
  void twoBlocksAreApartWhereAnAxisOfBothSeparatesThem() {
    SplittableRandom random = new SplittableRandom(7);
    for (int i = 0; i < 300; i++) {
      Pose pose =
          new Pose(
              random.nextDouble(-0.3, 0.3),
              random.nextDouble(-0.3, 0.3),
              random.nextDouble(-0.3, 0.5),
              random.nextDouble(-3, 3),
              random.nextDouble(-3, 3),
              random.nextDouble(-3, 3));
      SolidShape other = new SolidShape.Block(pose, 0.2, 0.3, 0.1);
      double apartM = BLOCK.toObstacle(at(0, 0, 0, 0), other);
      boolean separated = separated(pose);
      int at = i;
      assertEquals(separated, apartM > 0, () -> at + ": " + pose + " is " + apartM + " away");
    }
  }

  @Test
  void anotherToolIsAsFarAsAnObstacleInItsPlace() {
    SplittableRandom random = new SplittableRandom(8);
    ToolSolid other = new ToolSolid(new SolidShape.Block(Pose.ZERO, 0.2, 0.3, 0.1));
    for (int i = 0; i < 300; i++) {
      Pose pose =
          new Pose(
              random.nextDouble(-0.4, 0.4),
              random.nextDouble(-0.4, 0.4),
              random.nextDouble(-0.4, 0.6),
              random.nextDouble(-3, 3),
              random.nextDouble(-3, 3),
              random.nextDouble(-3, 3));
      double[] flange12 = new double[Transforms.SIZE];
      Transforms.of(pose, flange12);
      double[] own12 = at(0, 0, 0, 0);
      double obstacleM = BLOCK.toObstacle(own12, new SolidShape.Block(pose, 0.2, 0.3, 0.1));
      assertEquals(
          obstacleM, BLOCK.toTool(own12, other, flange12, Double.POSITIVE_INFINITY), 1e-12);
      assertEquals(
          obstacleM, other.toTool(flange12, BLOCK, own12, Double.POSITIVE_INFINITY), 1e-12);
      double boundM = BLOCK.toTool(own12, other, flange12, 0.02);
      assertTrue(boundM <= obstacleM + 1e-12 && (boundM >= 0.02 || boundM >= obstacleM - 1e-12));
    }
  }

  /** Whether one of the 15 axes of two blocks separates them (S. Gottschalk and others, 1996). */
  private static boolean separated(Pose pose) {
    double[] one = at(0, 0, 0.1, 0);
    double[] other = new double[Transforms.SIZE];
    Transforms.of(pose, other);
    double[] half = {0.05, 0.05, 0.1};
    double[] otherHalf = {0.1, 0.15, 0.05};
    for (int i = 0; i < 15; i++) {
      double[] axis = new double[3];
      for (int k = 0; k < 3; k++) {
        if (i < 3) {
          axis[k] = one[3 * k + i];
        } else if (i < 6) {
          axis[k] = other[3 * k + i - 3];
        } else {
          int a = (i - 6) / 3;
          int b = (i - 6) % 3;
          int k1 = 3 * ((k + 1) % 3);
          int k2 = 3 * ((k + 2) % 3);
          axis[k] = one[k1 + a] * other[k2 + b] - one[k2 + a] * other[k1 + b];
        }
      }
      double away = 0;
      double reach = 0;
      for (int k = 0; k < 3; k++) {
        away += axis[k] * (other[9 + k] - one[9 + k]);
      }
      for (int side = 0; side < 3; side++) {
        double along = 0;
        double otherAlong = 0;
        for (int k = 0; k < 3; k++) {
          along += axis[k] * one[3 * k + side];
          otherAlong += axis[k] * other[3 * k + side];
        }
        reach += half[side] * Math.abs(along) + otherHalf[side] * Math.abs(otherAlong);
      }
      if (Math.abs(away) > reach) {
        return true;
      }
    }
    return false;
  }

  @Test
  void aHullHasTheEdgesOfItsFaces() {
    SolidEdges edges = SolidEdges.of(Pose.ZERO, ConvexHull.prism(6, 0.1, 0.2));
    assertEquals(6 * 18, edges.ends().length);
  }
}
