package org.pendant.models.pose;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.junit.jupiter.api.Test;

class WrenchTest {
  private static final double EXACT = 1e-12;

  @Test
  void theSameFrameSeesTheSameWrench() {
    Wrench wrench = new Wrench(1, 2, 3, 4, 5, 6);
    near(wrench, wrench.seenFrom(Pose.ZERO), "identity");
  }

  @Test
  void aFrameFartherOutSeesTheForceWithTheTorqueOfItsLever() {
    // 10 N along x at the flange turn clockwise about y as seen from a TCP 0.1 m out along z
    Wrench atTcp = new Wrench(10, 0, 0, 0, 0, 0).seenFrom(new Pose(0, 0, 0.1, 0, 0, 0));
    near(new Wrench(10, 0, 0, 0, -1, 0), atTcp, "pure translation");
  }

  @Test
  void aForceThroughTheNewOriginHasNoTorqueThere() {
    // 10 N along x at the TCP, 0.1 m out along z, is felt at the flange with 1 Nm about y
    Wrench atTcp = new Wrench(10, 0, 0, 0, 1, 0).seenFrom(new Pose(0, 0, 0.1, 0, 0, 0));
    near(new Wrench(10, 0, 0, 0, 0, 0), atTcp, "force at the TCP");
  }

  @Test
  void aTurnedFrameSeesTheComponentsAlongItsOwnAxes() {
    Wrench seen = new Wrench(1, 0, 0, 0, 2, 0).seenFrom(new Pose(0, 0, 0, 0, 0, Math.PI / 2));
    near(new Wrench(0, -1, 0, 2, 0, 0), seen, "quarter turn about z");
  }

  @Test
  void twoStepsSeeTheSameAsTheirProduct() {
    Random random = new Random(31);
    for (int n = 0; n < 1000; n++) {
      Pose first = Samples.pose(random);
      Pose second = Samples.pose(random);
      Wrench wrench = random(random);
      near(
          wrench.seenFrom(Poses.trans(first, second)),
          wrench.seenFrom(first).seenFrom(second),
          wrench + " from " + first + " then " + second);
    }
  }

  @Test
  void powerIsTheSameFromEveryFrame() {
    Random random = new Random(32);
    for (int n = 0; n < 1000; n++) {
      Pose frame = Samples.pose(random);
      Wrench wrench = random(random);
      Wrench seen = wrench.seenFrom(frame);
      // a twist (v, w) at the old origin, moved to the new one and turned into its axes
      double[] v = {random.nextDouble(), random.nextDouble(), random.nextDouble()};
      double[] w = {random.nextDouble(), random.nextDouble(), random.nextDouble()};
      double[] r = new double[9];
      Rotations.vectorToMatrix(frame.rx(), frame.ry(), frame.rz(), r);
      double[] moved = {
        v[0] + w[1] * frame.z() - w[2] * frame.y(),
        v[1] + w[2] * frame.x() - w[0] * frame.z(),
        v[2] + w[0] * frame.y() - w[1] * frame.x()
      };
      double before = power(wrench, v, w);
      double after = power(seen, intoAxes(r, moved), intoAxes(r, w));
      assertEquals(before, after, 1e-12, () -> wrench + " from " + frame);
    }
  }

  private static double[] intoAxes(double[] r, double[] v) {
    return new double[] {
      r[0] * v[0] + r[3] * v[1] + r[6] * v[2],
      r[1] * v[0] + r[4] * v[1] + r[7] * v[2],
      r[2] * v[0] + r[5] * v[1] + r[8] * v[2]
    };
  }

  private static double power(Wrench f, double[] v, double[] w) {
    return f.fx() * v[0]
        + f.fy() * v[1]
        + f.fz() * v[2]
        + f.mx() * w[0]
        + f.my() * w[1]
        + f.mz() * w[2];
  }

  private static Wrench random(Random random) {
    return new Wrench(
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble());
  }

  private static void near(Wrench expected, Wrench actual, String message) {
    assertEquals(expected.fx(), actual.fx(), EXACT, message);
    assertEquals(expected.fy(), actual.fy(), EXACT, message);
    assertEquals(expected.fz(), actual.fz(), EXACT, message);
    assertEquals(expected.mx(), actual.mx(), EXACT, message);
    assertEquals(expected.my(), actual.my(), EXACT, message);
    assertEquals(expected.mz(), actual.mz(), EXACT, message);
  }
}
