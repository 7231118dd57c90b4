package org.pendant.models.kinematics;

import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** The arm under test, random joints, and the textbook product of Denavit-Hartenberg matrices. */
final class Arms {
  static final ArmDescription UR5E = ArmLibrary.load("ur5e");

  private Arms() {}

  /** Joint positions evenly spread over the whole range of the UR5e. */
  static Joints joints(Random random) {
    double[] q = new double[Joints.COUNT];
    for (int i = 0; i < q.length; i++) {
      q[i] = 2 * Math.PI * (2 * random.nextDouble() - 1);
    }
    return Joints.of(q);
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
    double[] d = {dh.d1(), 0, 0, dh.d4(), dh.d5(), dh.d6()};
    double[] a = {0, dh.a2(), dh.a3(), 0, 0, 0};
    double[] alpha = {Math.PI / 2, 0, 0, Math.PI / 2, -Math.PI / 2, 0};
    SimpleMatrix product = SimpleMatrix.identity(4);
    for (int i = 0; i < count; i++) {
      double c = Math.cos(q.get(i));
      double s = Math.sin(q.get(i));
      double ca = Math.cos(alpha[i]);
      double sa = Math.sin(alpha[i]);
      product =
          product.mult(
              new SimpleMatrix(
                  new double[][] {
                    {c, -s * ca, s * sa, a[i] * c},
                    {s, c * ca, -c * sa, a[i] * s},
                    {0, sa, ca, d[i]},
                    {0, 0, 0, 1}
                  }));
    }
    return product;
  }
}
