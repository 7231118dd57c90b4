package org.pendant.models.kinematics;

import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;

/**
 * The three ways in which an arm of this family loses a direction of motion. The determinant of the
 * Jacobian is, up to a constant, the product of their three measures.
 */
public enum Singularity {
  /** The wrist centre lies in the plane through the base axis and the parallel axes' direction. */
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
  /** Upper arm and forearm are in one line: the wrist cannot move along it. */
  ELBOW {
    @Override
    public double measure(DhLengths dh, Joints q) {
      return Math.abs(Math.sin(q.q2()));
    }
  },
  /** The axes of joints 4 and 6 are parallel. */
  WRIST {
    @Override
    public double measure(DhLengths dh, Joints q) {
      return Math.abs(Math.sin(q.q4()));
    }
  };

  /** How far joint positions (rad) are from this singularity: 0 in it, about 1 far from it. */
  public abstract double measure(DhLengths dh, Joints q);
}
