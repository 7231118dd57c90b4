package org.pendant.models.pose;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Test;

class PosesTest {
  private static final int CASES = 1000;
  private static final double EXACT = 1e-13;
  private static final double MANUAL_DIGITS = 6e-6;

  @Test
  void inverseGivesTheManualsExample() {
    near(
        Pose.of(0.19324, 0.41794, -0.29662, 1.23993, 0, 2.47985),
        Poses.inverse(Pose.of(.2, .5, .1, 1.57, 0, 3.14)),
        MANUAL_DIGITS,
        "pose_inv");
  }

  @Test
  void transGivesTheManualsExample() {
    near(
        Pose.of(0.4, -0.0996, 0.60048, 3.14, 0, 0),
        Poses.trans(Pose.of(.2, .5, .1, 1.57, 0, 0), Pose.of(.2, .5, .6, 1.57, 0, 0)),
        MANUAL_DIGITS,
        "pose_trans");
  }

  @Test
  void addAndSubGiveTheManualsExamples() {
    Pose first = Pose.of(.2, .5, .1, 1.57, 0, 0);
    Pose second = Pose.of(.2, .5, .6, 1.57, 0, 0);
    near(Pose.of(0.4, 1.0, 0.7, 3.14, 0, 0), Poses.add(first, second), EXACT, "pose_add");
    near(Pose.of(0, 0, -0.5, 0, 0, 0), Poses.sub(first, second), EXACT, "pose_sub");
  }

  @Test
  void distanceCountsAQuarterMetreForARadian() {
    Pose from = Pose.of(0, 0, 0, 0, 0, 0.5);
    assertEquals(0.25, Poses.distance(from, Pose.of(0.1, 0, 0, 0, 0, 1.5)), EXACT);
    assertEquals(0.3, Poses.distance(from, Pose.of(0, 0.3, 0, 0, 0, 1.5)), EXACT);
    assertEquals(
        0.5,
        Poses.pointDistance(Pose.of(.2, .5, .1, 1.57, 0, 3.14), Pose.of(.2, .5, .6, 0, 1.57, 3.14)),
        EXACT);
  }

  @Test
  void transIsTheProductOfHomogeneousMatrices() {
    Random random = new Random(11);
    for (int n = 0; n < CASES; n++) {
      Pose a = Samples.pose(random);
      Pose b = Samples.pose(random);
      SimpleMatrix expected = Samples.matrix(a).mult(Samples.matrix(b));
      SimpleMatrix actual = Samples.matrix(Poses.trans(a, b));
      assertTrue(expected.isIdentical(actual, 1e-12), () -> "trans of " + a + " and " + b);
    }
  }

  @Test
  void inverseUndoesTrans() {
    Random random = new Random(12);
    for (int n = 0; n < CASES; n++) {
      Pose p = Samples.pose(random);
      near(Pose.ZERO, Poses.trans(p, Poses.inverse(p)), 1e-13, "p inv(p) of " + p);
      near(Pose.ZERO, Poses.trans(Poses.inverse(p), p), 1e-13, "inv(p) p of " + p);
    }
  }

  @Test
  void addUndoesSub() {
    Random random = new Random(13);
    for (int n = 0; n < CASES; n++) {
      Pose to = Samples.pose(random);
      Pose from = Samples.pose(random);
      // positions commute, rotations do not: the difference stands on the left
      Pose back = Poses.add(Poses.sub(to, from), from);
      String input = "sub of " + to + " and " + from;
      assertEquals(0, Poses.pointDistance(to, back), 1e-13, input);
      assertEquals(0, Poses.rotationAngle(to, back), 1e-13, input);
    }
  }

  @Test
  void interpolateGivesItsEndsUnchanged() {
    Random random = new Random(14);
    for (int n = 0; n < CASES; n++) {
      Pose from = Samples.pose(random);
      Pose to = Samples.pose(random);
      assertEquals(from, Poses.interpolate(from, to, 0));
      assertEquals(to, Poses.interpolate(from, to, 1));
    }
  }

  @Test
  void interpolateDividesDistanceAndAngleEvenly() {
    Random random = new Random(15);
    for (int n = 0; n < CASES; n++) {
      Pose from = Samples.pose(random);
      Pose to = Samples.pose(random);
      double alpha = random.nextDouble();
      Pose between = Poses.interpolate(from, to, alpha);
      String input = alpha + " between " + from + " and " + to;
      assertEquals(
          alpha * Poses.pointDistance(from, to), Poses.pointDistance(from, between), 1e-12, input);
      assertEquals(
          alpha * Poses.rotationAngle(from, to), Poses.rotationAngle(from, between), 1e-12, input);
      assertEquals(
          (1 - alpha) * Poses.rotationAngle(from, to),
          Poses.rotationAngle(between, to),
          1e-12,
          input);
    }
  }

  @Test
  void interpolateGoesOnOutsideTheEnds() {
    Pose from = Pose.of(0, 0, 0, 0, 0, 0);
    Pose to = Pose.of(0.1, 0.2, 0.3, 0.4, 0, 0);
    near(Pose.of(0.2, 0.4, 0.6, 0.8, 0, 0), Poses.interpolate(from, to, 2), EXACT, "after");
    near(Pose.of(-0.1, -0.2, -0.3, -0.4, 0, 0), Poses.interpolate(from, to, -1), EXACT, "before");
  }

  @Test
  void straightLineGivesTheSameAsPoseAndAsTransformation() {
    Random random = new Random(16);
    double[] transform = new double[Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      StraightLine line = new StraightLine(Samples.pose(random), Samples.pose(random));
      double fraction = 3 * random.nextDouble() - 1;
      line.at(fraction, transform);
      SimpleMatrix expected = Samples.matrix(line.at(fraction));
      assertTrue(
          expected.isIdentical(Samples.matrix(transform), 1e-12),
          () -> fraction + " between " + line.from() + " and " + line.to());
    }
  }

  @Test
  void transformsMultiplyAndInvertLikePoses() {
    Random random = new Random(17);
    double[] a = new double[Transforms.SIZE];
    double[] b = new double[Transforms.SIZE];
    double[] product = new double[Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      Pose left = Samples.pose(random);
      Pose right = Samples.pose(random);
      Transforms.of(left, a);
      Transforms.of(right, b);
      Transforms.multiply(a, b, product);
      near(Poses.trans(left, right), Transforms.toPose(product), 1e-12, left + " times " + right);
      Transforms.invert(a, product);
      near(Poses.inverse(left), Transforms.toPose(product), 1e-12, "inverse of " + left);
    }
  }

  @Test
  void poseTellsItsComponentsByIndex() {
    Pose p = Pose.of(1, 2, 3, 4, 5, 6);
    for (int i = 0; i < Pose.SIZE; i++) {
      assertEquals(i + 1, p.get(i));
      assertEquals(9, p.with(i, 9).get(i));
      assertEquals(p, p.with(i, 9).with(i, i + 1));
    }
    assertThrows(IndexOutOfBoundsException.class, () -> p.get(6));
    assertThrows(IndexOutOfBoundsException.class, () -> p.with(-1, 0));
    assertThrows(IllegalArgumentException.class, () -> Pose.of(1, 2, 3));
  }

  @Test
  void resultsAreTheSameBitsBeforeAndAfterCompilation() {
    long first = fingerprint(1);
    for (int run = 0; run < 300; run++) {
      assertEquals(first, fingerprint(100), "run " + run);
    }
  }

  /** Bits of a thousand products; the repetitions make the compilers take an interest. */
  private static long fingerprint(int repetitions) {
    long bits = 0;
    for (int repetition = 0; repetition < repetitions; repetition++) {
      bits = 17;
      Pose p = Pose.of(.1, .2, .3, .4, .5, .6);
      Pose step = Pose.of(.01, -.02, .03, .31, -.22, .53);
      for (int n = 0; n < 10; n++) {
        p = Poses.trans(p, step);
        bits = 31 * bits + p.hashCode();
      }
    }
    return bits;
  }

  private static void near(Pose expected, Pose actual, double tolerance, String message) {
    for (int i = 0; i < Pose.SIZE; i++) {
      int component = i;
      assertEquals(
          expected.get(i),
          actual.get(i),
          tolerance,
          () -> message + ", component " + component + " of " + actual);
    }
  }
}
