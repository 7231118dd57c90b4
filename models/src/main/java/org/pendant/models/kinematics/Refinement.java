package org.pendant.models.kinematics;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Newton's method on the pose error of a calibrated arm, started from joint positions nearby.
 *
 * <p>Each step solves the damped equations of {@link Jacobian#solveDamped}; the damping falls while
 * steps succeed and rises when one does not (D. W. Marquardt, "An algorithm for least-squares
 * estimation of nonlinear parameters", 1963), so the error never grows.
 */
final class Refinement {
  /** Well below the errors allowed, well above rounding. */
  private static final double GOAL = 1e-13;

  private static final int MAX_STEPS = 40;
  private static final double FIRST_DAMPING = 1e-3;
  private static final double MIN_DAMPING = 1e-7;
  private static final double MAX_DAMPING = 10;

  private final ForwardKinematics forward;
  private final Jacobian jacobian;
  private final double[] reached = new double[Transforms.SIZE];
  private final double[] inverse = new double[Transforms.SIZE];
  private final double[] difference = new double[Transforms.SIZE];
  private final double[] rotation = new double[3];
  private final double[] error = new double[Joints.COUNT];
  private final double[] matrix = new double[Jacobian.SIZE];
  private final double[] step = new double[Joints.COUNT];
  private final double[] trial = new double[Joints.COUNT];

  Refinement(ArmDescription arm) {
    forward = new ForwardKinematics(arm);
    jacobian = new Jacobian(arm);
  }

  /**
   * Moves {@code q} to where it reaches the target, or as near as the method comes.
   *
   * @return whether both errors, in m and rad, are within the tolerance
   */
  boolean refine(double[] target, double[] q, double tolerance) {
    double damping = FIRST_DAMPING;
    double size = measure(target, q);
    for (int count = 0; count < MAX_STEPS && size > GOAL * GOAL; count++) {
      jacobian.at(q, Pose.ZERO, matrix);
      double before = size;
      while (damping <= MAX_DAMPING) {
        jacobian.solveDamped(matrix, error, damping, step);
        for (int i = 0; i < Joints.COUNT; i++) {
          trial[i] = q[i] + step[i];
        }
        size = measure(target, trial);
        if (size < before) {
          break;
        }
        damping *= 10;
        measure(target, q);
      }
      if (!(size < before)) {
        break;
      }
      System.arraycopy(trial, 0, q, 0, Joints.COUNT);
      damping = Math.max(MIN_DAMPING, 0.1 * damping);
    }
    forward.flange(q, reached);
    return PoseError.within(reached, target, tolerance);
  }

  /** Fills in the error as a twist of the flange and returns its square sum. */
  private double measure(double[] target, double[] q) {
    forward.flange(q, reached);
    Transforms.invert(reached, inverse);
    Transforms.multiply(target, inverse, difference);
    Rotations.matrixToVector(difference, rotation);
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      error[i] = target[9 + i] - reached[9 + i];
      error[3 + i] = rotation[i];
      sum += error[i] * error[i] + rotation[i] * rotation[i];
    }
    return sum;
  }
}
