package org.pendant.models.kinematics;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;

/**
 * The three ways in which an arm of this family loses a direction of motion. The determinant of the
 * Jacobian is, up to a constant, the product of their three measures.
 *
 * <p>{@link InverseKinematics} says what the inverse does in each.
 */
public enum Singularity {
  /**
   * The wrist centre lies in the plane through the base axis and the parallel axes' direction, as
   * near to the base axis as it gets. Two shoulders meet.
   */
  SHOULDER {
    @Override
    double measure(DhLengths dh, double q1, double q2, double q3, double q4) {
      double u =
          dh.a2() * Math.cos(q1) + dh.a3() * Math.cos(q1 + q2) + dh.d5() * Math.sin(q1 + q2 + q3);
      return Math.abs(u) / (Math.abs(dh.a2()) + Math.abs(dh.a3()));
    }
  },
  /** Upper arm and forearm are in one line: the wrist cannot move along it. Two elbows meet. */
  ELBOW {
    @Override
    double measure(DhLengths dh, double q1, double q2, double q3, double q4) {
      return Math.abs(Math.sin(q2));
    }
  },
  /** The axes of joints 4 and 6 are parallel: they turn against each other freely. */
  WRIST {
    @Override
    double measure(DhLengths dh, double q1, double q2, double q3, double q4) {
      return Math.abs(Math.sin(q4));
    }
  };

  /**
   * How far joint positions (rad) are from this singularity: 0 in it, about 1 far from it. That of
   * a calibrated arm is nearby.
   */
  public double measure(DhLengths dh, Joints q) {
    return measure(dh, q.q1(), q.q2(), q.q3(), q.q4());
  }

  /**
   * As {@link #measure(DhLengths, Joints)}, without allocating.
   *
   * @param q six joint positions, rad
   */
  public double measure(DhLengths dh, double[] q) {
    return measure(dh, q[1], q[2], q[3], q[4]);
  }

  /** The same; none depends on the first joint or the last. */
  abstract double measure(DhLengths dh, double q1, double q2, double q3, double q4);
}
