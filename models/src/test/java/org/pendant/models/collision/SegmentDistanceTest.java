package org.pendant.models.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.mesh.SegmentDistance;
import org.pendant.models.pose.Pose;

class SegmentDistanceTest {
  private final Random random = new Random(7);

  @Test
  void crossingLinesAreAsFarApartAsTheirPlanes() {
    assertEquals(
        0.3,
        SegmentDistance.apart(
            new double[] {-1, 0, 0, 1, 0, 0}, 0, new double[] {0, -1, 0.3, 0, 1, 0.3}, 0),
        1e-15);
  }

  @Test
  void linesThatTouchAreNotApart() {
    assertEquals(
        0,
        SegmentDistance.apart(
            new double[] {0, 0, 0, 1, 0, 0}, 0, new double[] {0.25, 0, 0, 0.25, 2, 0}, 0),
        1e-15);
  }

  @Test
  void noTwoPointsOfTwoLinesAreNearerThanTheyAre() {
    for (int n = 0; n < 300; n++) {
      double[] one = line(n % 5 == 0 ? 0 : 1);
      double[] other = n % 7 == 0 ? parallel(one) : line(n % 3 == 0 ? 0 : 1);
      double apart = SegmentDistance.apart(one, 0, other, 0);
      double least = Double.MAX_VALUE;
      for (int i = 0; i <= 60; i++) {
        double[] p = along(one, i / 60.0);
        least =
            Math.min(
                least,
                SegmentDistance.toPoint(
                    other[0], other[1], other[2], other[3], other[4], other[5], p[0], p[1], p[2]));
      }
      int number = n;
      double found = least;
      assertTrue(apart <= least + 1e-12, () -> number + ": " + apart + ", but " + found);
      // between the points that were tried it may be a little nearer
      assertTrue(least - apart < 0.03, () -> number + ": " + apart + ", but " + found);
      assertEquals(apart, SegmentDistance.apart(other, 0, one, 0), 1e-12);
    }
  }

  @Test
  void noPointOfALineIsNearerToAnObstacleThanTheLineIs() {
    for (int n = 0; n < 300; n++) {
      SolidShape obstacle = obstacle(n);
      double[] line = line(n % 5 == 0 ? 0 : 1);
      double distance = obstacle.toSegment(line[0], line[1], line[2], line[3], line[4], line[5]);
      double least = Double.MAX_VALUE;
      for (int i = 0; i <= 100; i++) {
        double[] p = along(line, i / 100.0);
        least = Math.min(least, obstacle.toPoint(p[0], p[1], p[2]));
      }
      int number = n;
      double found = least;
      assertTrue(distance <= least + 1e-7, () -> number + ": " + distance + ", but " + found);
      assertTrue(least - distance < 0.02, () -> number + ": " + distance + ", but " + found);
    }
  }

  @Test
  void theDistanceOfAPointFromAnObstacleChangesNoFasterThanThePointMoves() {
    for (int n = 0; n < 1000; n++) {
      SolidShape obstacle = obstacle(n);
      double[] two = line(1);
      double apart =
          Math.sqrt(
              Math.pow(two[3] - two[0], 2)
                  + Math.pow(two[4] - two[1], 2)
                  + Math.pow(two[5] - two[2], 2));
      double change =
          obstacle.toPoint(two[0], two[1], two[2]) - obstacle.toPoint(two[3], two[4], two[5]);
      int number = n;
      assertTrue(Math.abs(change) <= apart + 1e-12, () -> number + ": " + change);
    }
  }

  @Test
  void aLineThroughABlockIsAsDeepAsItsDeepestPoint() {
    SolidShape block = new SolidShape.Block(new Pose(1, 0, 0, 0, 0, Math.PI / 2), 0.2, 1, 1);
    assertEquals(-0.1, block.toSegment(1, -1, 0, 1, 1, 0), 1e-7);
    assertEquals(-0.04, block.toSegment(0.5, 0.06, 0, 1.5, 0.06, 0), 1e-7);
    assertEquals(0.5, block.toSegment(1, 0.1, 3, 1, 0.1, 1), 1e-7);
  }

  private SolidShape obstacle(int n) {
    return switch (n % 5) {
      case 0 ->
          new SolidShape.Block(
              new Pose(number(), number(), number(), 3 * number(), 3 * number(), 3 * number()),
              0.1 + random.nextDouble(),
              0.1 + random.nextDouble(),
              0.1 + random.nextDouble());
      case 1 -> new SolidShape.Ball(number(), number(), number(), 0.1 + random.nextDouble());
      case 2, 3 ->
          new SolidShape.Rod(
              new Pose(number(), number(), number(), 3 * number(), 3 * number(), 3 * number()),
              0.1 + 0.5 * random.nextDouble(),
              0.1 + random.nextDouble(),
              n % 5 == 2);
      default -> {
        double angle = 6 * number();
        yield new SolidShape.HalfSpace(
            number(), number(), number(), Math.cos(angle), 0, Math.sin(angle));
      }
    };
  }

  private double[] line(double length) {
    double[] line = new double[6];
    for (int i = 0; i < 3; i++) {
      line[i] = number();
      line[3 + i] = line[i] + length * number();
    }
    return line;
  }

  private double[] parallel(double[] line) {
    double[] other = line.clone();
    for (int i = 0; i < 3; i++) {
      double shift = number();
      other[i] += shift;
      other[3 + i] += shift;
    }
    return other;
  }

  private double number() {
    return 2 * random.nextDouble() - 1;
  }

  private static double[] along(double[] line, double share) {
    double[] point = new double[3];
    for (int i = 0; i < 3; i++) {
      point[i] = line[i] + share * (line[3 + i] - line[i]);
    }
    return point;
  }
}
