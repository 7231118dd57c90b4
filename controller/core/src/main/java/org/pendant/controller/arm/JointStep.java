package org.pendant.controller.arm;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.TriangularSolver_DDRM;
import org.ejml.dense.row.misc.UnrolledCholesky_DDRM;
import org.pendant.models.arm.Joints;

/**
 * Integration step of the joint speeds, with motors and dry friction that act on the speeds at its
 * end.
 *
 * <p>Wanted is the speed v after a step dt in
 *
 * <pre>
 *   M (v - v0) = dt (motor(v) + free - viscous v - dry),   |dry| at most coulomb
 * </pre>
 *
 * where {@code motor = clamp(drive - slope v, -limit, limit)}, and {@code dry} opposes v with its
 * full size, or holds v at exactly 0 where less is enough. Because everything depends on the new
 * speed and only ever brakes it, the step is stable for any slope and the solution is unique: it is
 * the minimum of a convex function. (J. J. Moreau, "Unilateral contact and dry friction in finite
 * freedom dynamics", 1988, for the idea.) Each joint slides one way, or the other, or sticks, and
 * its motor is at a limit or not; what is assumed about that is corrected until it is consistent,
 * mostly at once.
 */
final class JointStep {
  /** Corrections of all joints at once; beyond, which hardly ever happens, one joint at a time. */
  private static final int BOLD_ROUNDS = 8;

  private static final int MAX_ROUNDS = 60;

  /** Share by which static friction may be exceeded: more than rounding, less than matters. */
  private static final double ROUNDING = 1e-9;

  private static final int N = Joints.COUNT;

  /** Inertia of the joints, rotors included, kg m². */
  final DMatrixRMaj massKgM2 = new DMatrixRMaj(N, N);

  /** Torques that do not depend on the new speeds: from outside, less weight and Coriolis, Nm. */
  final double[] freeNm = new double[N];

  /** Motor torque at speed 0 as the drive wants it, Nm. */
  final double[] driveNm = new double[N];

  /** By how much the drive lowers its torque for each rad/s of the new speed, Nm s/rad. */
  final double[] slopeNmSPerRad = new double[N];

  /** Largest torque of the motors, Nm. */
  final double[] limitNm = new double[N];

  /** Dry friction, Nm. */
  final double[] coulombNm = new double[N];

  /** Viscous friction, Nm s/rad. */
  final double[] viscousNmSPerRad = new double[N];

  /** Result: what the motors gave, Nm. */
  final double[] motorNm = new double[N];

  /** Result: 1 or -1 where the motor is at its limit, otherwise 0. */
  final int[] limited = new int[N];

  private final int[] slides = new int[N];
  private final double[] start = new double[N];
  private final double[] result = new double[N];
  private final DMatrixRMaj system = new DMatrixRMaj(N, N);
  private final DMatrixRMaj factor = new DMatrixRMaj(N, N);

  /**
   * Advances the speeds.
   *
   * @param stepS length of the step, s
   * @param speedRadPerS six speeds, overwritten with those after the step
   */
  void solve(double stepS, double[] speedRadPerS) {
    double[] mass = massKgM2.data;
    for (int i = 0; i < N; i++) {
      slides[i] = (int) Math.signum(speedRadPerS[i]);
      limited[i] = beyondLimit(i, speedRadPerS[i]);
      start[i] = row(mass, i, speedRadPerS) + stepS * freeNm[i];
    }
    for (int round = 0; round < MAX_ROUNDS; round++) {
      speeds(stepS);
      if (!revise(stepS, round >= BOLD_ROUNDS)) {
        break;
      }
    }
    for (int i = 0; i < N; i++) {
      motorNm[i] = motor(i, result[i]);
      speedRadPerS[i] = result[i];
    }
  }

  /** The speeds that follow from what is assumed about each joint. */
  private void speeds(double stepS) {
    double[] a = system.data;
    boolean allStick = true;
    System.arraycopy(massKgM2.data, 0, a, 0, N * N);
    for (int i = 0; i < N; i++) {
      if (slides[i] == 0) {
        isolate(a, i);
        result[i] = 0;
        continue;
      }
      allStick = false;
      double torque = driveOrLimit(i) - slides[i] * coulombNm[i];
      result[i] = start[i] + stepS * torque;
      a[N * i + i] += stepS * (slope(i) + viscousNmSPerRad[i]);
    }
    if (allStick) {
      return;
    }
    if (!UnrolledCholesky_DDRM.lower6(system, factor)) {
      throw new IllegalStateException("the mass matrix is not positive: " + massKgM2);
    }
    TriangularSolver_DDRM.solveL(factor.data, result, N);
    TriangularSolver_DDRM.solveTranL(factor.data, result, N);
  }

  /** Takes joint i out of the equations, its speed being 0. */
  private static void isolate(double[] a, int i) {
    Arrays.fill(a, N * i, N * i + N, 0);
    for (int k = 0; k < N; k++) {
      a[N * k + i] = 0;
    }
    a[N * i + i] = 1;
  }

  /** Corrects the assumptions that the speeds contradict; false if there are none. */
  private boolean revise(double stepS, boolean oneOnly) {
    boolean changed = false;
    for (int i = 0; i < N && !(changed && oneOnly); i++) {
      changed |= reviseLimit(i);
      if (!(changed && oneOnly)) {
        changed |= reviseFriction(stepS, i);
      }
    }
    return changed;
  }

  private boolean reviseLimit(int i) {
    int side = beyondLimit(i, result[i]);
    if (side == -limited[i]) {
      side = 0;
    }
    boolean changed = side != limited[i];
    limited[i] = side;
    return changed;
  }

  private boolean reviseFriction(double stepS, int i) {
    int now = slides[i];
    if (now != 0) {
      if (now * result[i] < 0) {
        slides[i] = 0;
      }
    } else {
      double held = start[i] / stepS + driveOrLimit(i) - row(massKgM2.data, i, result) / stepS;
      if (Math.abs(held) > coulombNm[i] * (1 + ROUNDING)) {
        slides[i] = held > 0 ? 1 : -1;
      }
    }
    return slides[i] != now;
  }

  private double motor(int i, double speedRadPerS) {
    double wanted = driveNm[i] - slopeNmSPerRad[i] * speedRadPerS;
    return Math.max(-limitNm[i], Math.min(limitNm[i], wanted));
  }

  private double driveOrLimit(int i) {
    return limited[i] == 0 ? driveNm[i] : limited[i] * limitNm[i];
  }

  private double slope(int i) {
    return limited[i] == 0 ? slopeNmSPerRad[i] : 0;
  }

  /** On which side of its limits the drive wants the torque of a motor to be; 0 if within. */
  private int beyondLimit(int i, double speedRadPerS) {
    double wanted = driveNm[i] - slopeNmSPerRad[i] * speedRadPerS;
    return Math.abs(wanted) <= limitNm[i] ? 0 : (int) Math.signum(wanted);
  }

  private static double row(double[] matrix, int row, double[] v) {
    int at = N * row;
    return matrix[at] * v[0]
        + matrix[at + 1] * v[1]
        + matrix[at + 2] * v[2]
        + matrix[at + 3] * v[3]
        + matrix[at + 4] * v[4]
        + matrix[at + 5] * v[5];
  }
}
