package org.pendant.motion.toolpath;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.StraightLine;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.ToolCurve;

/** The derivatives of every kind of way, against differences. */
class CurvesTest {
  private static final double STEP = 1e-5;

  private final SplittableRandom random = new SplittableRandom(11);

  private Pose pose(double around) {
    double[] numbers = new double[Pose.SIZE];
    for (int i = 0; i < Pose.SIZE; i++) {
      numbers[i] = random.nextDouble(-around, around);
    }
    return Pose.of(numbers);
  }

  private static void compare(ToolCurve curve, double at, String what) {
    double[] low = new double[Transforms.SIZE];
    double[] high = new double[Transforms.SIZE];
    double[] middle = new double[Transforms.SIZE];
    double[] rate = new double[6];
    double[] before = new double[6];
    double[] after = new double[6];
    double[] bend = new double[6];
    curve.at(at - STEP, low);
    curve.at(at + STEP, high);
    curve.at(at, middle);
    curve.rate(at, rate);
    curve.rate(at - STEP, before);
    curve.rate(at + STEP, after);
    curve.bend(at, bend);
    for (int i = 0; i < 3; i++) {
      assertEquals((high[9 + i] - low[9 + i]) / (2 * STEP), rate[i], 1e-5, what + " rate " + i);
    }
    // w x column is how each column of the rotation changes
    for (int column = 0; column < 3; column++) {
      double x = middle[column];
      double y = middle[3 + column];
      double z = middle[6 + column];
      double[] changes = {
        rate[4] * z - rate[5] * y, rate[5] * x - rate[3] * z, rate[3] * y - rate[4] * x
      };
      for (int row = 0; row < 3; row++) {
        int k = 3 * row + column;
        assertEquals((high[k] - low[k]) / (2 * STEP), changes[row], 1e-5, what + " turning");
      }
    }
    for (int i = 0; i < 6; i++) {
      double difference = (after[i] - before[i]) / (2 * STEP);
      assertEquals(difference, bend[i], 1e-4 * (1 + Math.abs(difference)), what + " bend " + i);
    }
  }

  private ToolCurve straight() {
    return new LineSegment(new StraightLine(pose(0.5), pose(0.5)), 0.4);
  }

  private ArcSegment arc(boolean withTangent) {
    return ArcSegment.through(pose(0.5), pose(0.5), pose(0.5), withTangent).orElseThrow().over(0.7);
  }

  @Test
  void derivativesOfLinesArcsAndCornersAreTrue() {
    for (int i = 0; i < 200; i++) {
      compare(straight(), 0.3, "line");
      compare(arc(i % 2 == 0), 0.3, "arc");
      compare(
          new CornerSegment(straight(), 0.4, straight(), 0.1), random.nextDouble(0.2), "corner");
      compare(new CornerSegment(arc(true), 0.7, straight(), 0.1), random.nextDouble(0.2), "corner");
    }
  }

  @Test
  void derivativesOfACarriedAndOfASpunWayAreTrue() {
    for (int i = 0; i < 200; i++) {
      double at = random.nextDouble(0.05, 0.15);
      CornerSegment corner = new CornerSegment(straight(), 0.4, arc(false), 0.1);
      compare(new RemoteTcpCurve(corner, pose(1)), at, "carried");
      double[] angles = random.doubles(6, -1, 1).toArray();
      Spline spline = new Spline(angles, 0.04);
      // off the knots, where the third derivative jumps
      double between = 0.04 * Math.floor(at / 0.04) + 0.02;
      compare(new RotatedSegment(corner, spline), between, "spun");
      compare(
          new RemoteTcpCurve(new RotatedSegment(corner, spline), pose(1)),
          between,
          "spun, carried");
    }
  }

  @Test
  void aSplineMeetsItsValuesAndEndsLevel() {
    double[] values = random.doubles(9, -2, 2).toArray();
    Spline spline = new Spline(values, 0.5);
    for (int i = 0; i < values.length; i++) {
      assertEquals(values[i], spline.value(0.5 * i), 1e-12);
    }
    assertEquals(0, spline.slope(0), 1e-12);
    assertEquals(0, spline.slope(4), 1e-12);
    for (int i = 1; i < 8; i++) {
      double knot = 0.5 * i;
      assertEquals(spline.slope(knot - 1e-9), spline.slope(knot + 1e-9), 1e-6);
      assertEquals(spline.bend(knot - 1e-9), spline.bend(knot + 1e-9), 1e-6);
    }
  }

  @Test
  void anArcStaysOnItsCircleAndPassesItsThreePoints() {
    for (int i = 0; i < 200; i++) {
      Pose from = pose(0.5);
      Pose via = pose(0.5);
      Pose to = pose(0.5);
      ArcSegment arc = ArcSegment.through(from, via, to, false).orElseThrow().over(1);
      double nearest = Double.POSITIVE_INFINITY;
      double[] point = new double[Transforms.SIZE];
      for (int k = 0; k <= 4000; k++) {
        arc.at(k / 4000.0, point);
        double x = point[9] - via.x();
        double y = point[10] - via.y();
        double z = point[11] - via.z();
        nearest = Math.min(nearest, Math.sqrt(x * x + y * y + z * z));
      }
      assertTrue(nearest < arc.arcM() / 7000 + 1e-9, nearest + " m from via");
      for (int k = 0; k < 6; k++) {
        assertEquals(to.get(k), arc.end().get(k), 1e-9);
      }
      assertTrue(arc.arcM() > 0);
    }
  }
}
