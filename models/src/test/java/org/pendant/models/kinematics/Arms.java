package org.pendant.models.kinematics;

import java.util.List;
import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Arms under test, random joints, and the textbook product of Denavit-Hartenberg matrices. */
final class Arms {
  static final ArmDescription UR5E = ArmLibrary.load("ur5e");

  /** All models. */
  static final List<ArmDescription> ALL = ArmLibrary.ids().stream().map(ArmLibrary::load).toList();

  private Arms() {}

  /** Joint positions evenly spread over two turns, the whole range of most joints. */
  static Joints joints(Random random) {
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < q.length; i++) {
      q[i] = 2 * Math.PI * (2 * random.nextDouble() - 1);
    }
    return Joints.of(q);
  }

  /** The least of the three measures of singularity. */
  static double regularity(DhLengths dh, Joints q) {
    double least = 1;
    for (Singularity singularity : Singularity.values()) {
      least = Math.min(least, singularity.measure(dh, q));
    }
    return least;
  }

  /** Random joints with each measure of singularity above a bound. */
  static Joints regularJoints(DhLengths dh, double bound, Random random) {
    Joints q = joints(random);
    while (regularity(dh, q) < bound) {
      q = joints(random);
    }
    return q;
  }

  /**
   * Joints within a turn each and with the wrist centre in the plane that holds the base axis, away
   * from the other two singularities.
   */
  static Joints overTheShoulder(DhLengths dh, Random random) {
    while (true) {
      Joints q = joints(random);
      double u = dh.a2() * Math.cos(q.q1()) + dh.d5() * Math.sin(q.q3());
      if (Math.abs(u) < Math.abs(dh.a3())) {
        double sum = Math.acos(-u / dh.a3());
        Joints over = q.with(2, sum - q.q1()).with(3, q.q3() - sum);
        if (over.maxAbsDifference(Joints.ZERO) < 2 * Math.PI
            && Singularity.ELBOW.measure(dh, over) > 0.05
            && Singularity.WRIST.measure(dh, over) > 0.05) {
          return over;
        }
      }
    }
  }

  /** Largest difference (rad) of two joint positions, full turns aside. */
  static double turnlessDifference(Joints a, Joints b) {
    double largest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      largest = Math.max(largest, Math.abs(Math.IEEEremainder(a.get(i) - b.get(i), 2 * Math.PI)));
    }
    return largest;
  }

  /** True if joint positions are among the solutions, full turns aside. */
  static boolean contain(List<Joints> solutions, Joints q, double toleranceRad) {
    return solutions.stream().anyMatch(each -> turnlessDifference(each, q) < toleranceRad);
  }

  static Pose tcp(Random random) {
    return new Pose(
        random.nextDouble() - 0.5,
        random.nextDouble() - 0.5,
        random.nextDouble() - 0.5,
        random.nextDouble(),
        random.nextDouble(),
        random.nextDouble());
  }

  /** Product of the first {@code count} matrices {@code Rz(q) Tz(d) Tx(a) Rx(alpha)}. */
  static SimpleMatrix chain(DhLengths dh, Joints q, int count) {
    return chain(dh, DhDeltas.NONE, q, count);
  }

  /** The same with calibration deltas. */
  static SimpleMatrix chain(DhLengths dh, DhDeltas deltas, Joints q, int count) {
    double[] d = {dh.d1(), 0, 0, dh.d4(), dh.d5(), dh.d6()};
    double[] a = {0, dh.a2(), dh.a3(), 0, 0, 0};
    double[] alpha = {Math.PI / 2, 0, 0, Math.PI / 2, -Math.PI / 2, 0};
    SimpleMatrix product = SimpleMatrix.identity(4);
    for (int i = 0; i < count; i++) {
      double c = Math.cos(q.get(i) + deltas.thetaRad().get(i));
      double s = Math.sin(q.get(i) + deltas.thetaRad().get(i));
      double length = a[i] + deltas.aM().get(i);
      double offset = d[i] + deltas.dM().get(i);
      double ca = Math.cos(alpha[i] + deltas.alphaRad().get(i));
      double sa = Math.sin(alpha[i] + deltas.alphaRad().get(i));
      product =
          product.mult(
              new SimpleMatrix(
                  new double[][] {
                    {c, -s * ca, s * sa, length * c},
                    {s, c * ca, -c * sa, length * s},
                    {0, sa, ca, offset},
                    {0, 0, 0, 1}
                  }));
    }
    return product;
  }
}
