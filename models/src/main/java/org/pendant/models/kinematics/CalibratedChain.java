package org.pendant.models.kinematics;

import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;

/**
 * The plain product of six Denavit-Hartenberg matrices {@code Rz(theta) Tz(d) Tx(a) Rx(alpha)}, for
 * an arm whose axes are not exactly parallel or square to each other.
 */
final class CalibratedChain {
  /** The nominal angle between the axes before and after each link, in quarter turns. */
  private static final int[] QUARTERS = {1, 0, 0, 1, -1, 0};

  private final double[] theta;
  private final double[] a;
  private final double[] d;
  private final double[] cosAlpha = new double[Joints.COUNT];
  private final double[] sinAlpha = new double[Joints.COUNT];

  CalibratedChain(DhLengths dh, DhDeltas deltas) {
    theta = deltas.thetaRad().toArray();
    a = sum(deltas.aM(), 0, dh.a2(), dh.a3(), 0, 0, 0);
    d = sum(deltas.dM(), dh.d1(), 0, 0, dh.d4(), dh.d5(), dh.d6());
    for (int i = 0; i < Joints.COUNT; i++) {
      // quarter turns are put in by hand: the cosine of a rounded pi/2 is not zero
      double cosine = Math.cos(deltas.alphaRad().get(i));
      double sine = Math.sin(deltas.alphaRad().get(i));
      cosAlpha[i] = QUARTERS[i] == 0 ? cosine : -QUARTERS[i] * sine;
      sinAlpha[i] = QUARTERS[i] == 0 ? sine : QUARTERS[i] * cosine;
    }
  }

  private static double[] sum(Joints deltas, double... nominal) {
    double[] sum = deltas.toArray();
    for (int i = 0; i < sum.length; i++) {
      sum[i] += nominal[i];
    }
    return sum;
  }

  /** Frames 1 to 6 in the base frame, six transformations, overwritten. */
  void frames(double[] q, double[][] frames) {
    start(q[0], frames[0]);
    for (int i = 1; i < Joints.COUNT; i++) {
      System.arraycopy(frames[i - 1], 0, frames[i], 0, frames[i].length);
      advance(i, q[i], frames[i]);
    }
  }

  /** Frame 6 in the base frame, overwritten. */
  void flange(double[] q, double[] transform) {
    start(q[0], transform);
    for (int i = 1; i < Joints.COUNT; i++) {
      advance(i, q[i], transform);
    }
  }

  private void start(double q, double[] transform) {
    for (int i = 0; i < transform.length; i++) {
      transform[i] = i == 0 || i == 4 || i == 8 ? 1 : 0;
    }
    advance(0, q, transform);
  }

  /** Multiplies by the matrix of joint i, in place. */
  private void advance(int i, double q, double[] transform) {
    double c = Math.cos(q + theta[i]);
    double s = Math.sin(q + theta[i]);
    for (int row = 0; row < 9; row += 3) {
      double x = c * transform[row] + s * transform[row + 1];
      double y = c * transform[row + 1] - s * transform[row];
      double z = transform[row + 2];
      transform[row] = x;
      transform[row + 1] = cosAlpha[i] * y + sinAlpha[i] * z;
      transform[row + 2] = cosAlpha[i] * z - sinAlpha[i] * y;
      transform[9 + row / 3] += a[i] * x + d[i] * z;
    }
  }
}
