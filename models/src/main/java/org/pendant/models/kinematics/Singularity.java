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
    public double measure(DhLengths dh, Joints q) {
      double u =
          dh.a2() * Math.cos(q.q1())
              + dh.a3() * Math.cos(q.q1() + q.q2())
              + dh.d5() * Math.sin(q.q1() + q.q2() + q.q3());
      return Math.abs(u) / (Math.abs(dh.a2()) + Math.abs(dh.a3()));
    }
  },
  /** Upper arm and forearm are in one line: the wrist cannot move along it. Two elbows meet. */
  ELBOW {
    @Override
    public double measure(DhLengths dh, Joints q) {
      return Math.abs(Math.sin(q.q2()));
    }
  },
  /** The axes of joints 4 and 6 are parallel: they turn against each other freely. */
  WRIST {
    @Override
    public double measure(DhLengths dh, Joints q) {
      return Math.abs(Math.sin(q.q4()));
    }
  };

  /**
   * How far joint positions (rad) are from this singularity: 0 in it, about 1 far from it. That of
   * a calibrated arm is nearby.
   */
  public abstract double measure(DhLengths dh, Joints q);
}
