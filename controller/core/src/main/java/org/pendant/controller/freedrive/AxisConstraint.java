package org.pendant.controller.freedrive;

import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.decomposition.TriangularSolver_DDRM;
import org.ejml.dense.row.misc.UnrolledCholesky_DDRM;
import org.ejml.dense.row.mult.MatrixVectorMult_DDRM;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;

/**
 * Axis constraint: holds the tool centre point along the axes that are not free in freedrive; the
 * free axes feel nothing of it.
 *
 * <p>Each locked axis has a spring, a damper and an integral, laid out for the mass that the arm
 * has along the locked axes together: the joint torques are {@code Jᵀ F} with {@code F = (J M⁻¹
 * Jᵀ)⁻¹ a}, where the rows of J are those of the locked axes and a is the acceleration that the
 * springs ask for. (O. Khatib, "A unified approach for motion and force control of robot
 * manipulators: the operational space formulation", 1987, equations 14 and 20.) In a singularity
 * that mass is endless; what is added to its inverse bounds it, and the lock gets weaker there.
 *
 * <p>Turning is counted up from frame to frame, so that a free axis may turn without end.
 */
final class AxisConstraint {
  /** The three poles of each lock, 1/s. */
  private static final double RATE_PER_S = 80;

  private static final double SPRING = 3 * RATE_PER_S * RATE_PER_S;
  private static final double DAMPER = 3 * RATE_PER_S;
  private static final double INTEGRAL = RATE_PER_S * RATE_PER_S * RATE_PER_S;

  /** How far a hand may push the lock open, m; pushed further it slips. */
  private static final double SLIP_M = 0.005;

  private static final double SLIP_RAD = 0.03;

  /** Nearer than this nothing is integrated, m: ends the hunt for the last bit. */
  private static final double CLOSE_ENOUGH_M = 1e-5;

  private static final double CLOSE_ENOUGH_RAD = 5e-5;

  /** Inverse of the largest mass that is reckoned with, 1/kg. */
  private static final double MIN_MOBILITY_PER_KG = 0.005;

  /** The same for turning, 1/(kg m²). */
  private static final double MIN_MOBILITY_PER_KG_M2 = 0.1;

  private static final int N = Joints.COUNT;

  private final ArmDynamics model;
  private final ForwardKinematics forward;
  private final Jacobian jacobian;
  private final double[] flange12 = new double[Transforms.SIZE];
  private final double[] tool12 = new double[Transforms.SIZE];
  private final double[] tcp12 = new double[Transforms.SIZE];
  private final double[] before12 = new double[Transforms.SIZE];
  private final double[] axes12 = new double[Transforms.SIZE];
  private final double[] jacobian36 = new double[Jacobian.SIZE];
  private final double[] anchor3 = new double[3];
  private final double[] error = new double[N];
  private final double[] sum = new double[N];
  private final DMatrixRMaj rows = new DMatrixRMaj(N, N);
  private final DMatrixRMaj moved = new DMatrixRMaj(N, N);
  private final double[] column = new double[N];
  private final int[] locked = new int[N];
  private final DMatrixRMaj mass = new DMatrixRMaj(N, N);
  private final DMatrixRMaj massFactor = new DMatrixRMaj(N, N);
  private final DMatrixRMaj mobility = new DMatrixRMaj(N, N);
  private final DMatrixRMaj mobilityFactor = new DMatrixRMaj(N, N);
  private final DMatrixRMaj force = new DMatrixRMaj(N, 1);

  /** Speeds along the locked axes. */
  private final DMatrixRMaj lockedSpeed = new DMatrixRMaj(N, 1);

  /** Views of the arrays that are handed over. */
  private final DMatrixRMaj speed = new DMatrixRMaj(N, 1);

  private final DMatrixRMaj torque = new DMatrixRMaj(N, 1);
  private Pose tcpInFlange = Pose.ZERO;
  private int count;

  AxisConstraint(ArmDescription arm, ArmDynamics model) {
    this.model = model;
    forward = new ForwardKinematics(arm);
    jacobian = new Jacobian(arm);
  }

  /**
   * Freedrive begins: the tool centre point is kept where it is, along the locked axes.
   *
   * @param q joint positions, rad
   */
  void begin(FreeAxes axes, FreedriveFrame frame, Pose tcpInFlange, double[] q) {
    this.tcpInFlange = tcpInFlange;
    Transforms.of(tcpInFlange, tool12);
    locate(q);
    switch (frame) {
      case FreedriveFrame.Base _ -> Transforms.of(Pose.ZERO, axes12);
      case FreedriveFrame.Tool _ -> System.arraycopy(tcp12, 0, axes12, 0, axes12.length);
      case FreedriveFrame.Feature feature -> Transforms.of(feature.inBase(), axes12);
    }
    count = 0;
    for (int axis = 0; axis < N; axis++) {
      if (!axes.free(axis)) {
        locked[count++] = axis;
      }
    }
    // the kernels go by the size of the matrix
    rows.reshape(count, N);
    moved.reshape(count, N);
    force.reshape(count, 1);
    mobility.reshape(count, count);
    mobilityFactor.reshape(count, count);
    hold(q);
  }

  /** From now on the tool centre point is elsewhere on the tool; it is kept where it is. */
  void setTool(Pose tcpInFlange, double[] q) {
    this.tcpInFlange = tcpInFlange;
    Transforms.of(tcpInFlange, tool12);
    hold(q);
  }

  private void hold(double[] q) {
    locate(q);
    System.arraycopy(tcp12, 9, anchor3, 0, 3);
    System.arraycopy(tcp12, 0, before12, 0, before12.length);
    Arrays.fill(error, 0);
    Arrays.fill(sum, 0);
  }

  /** Whether any axis is locked. */
  boolean locks() {
    return count > 0;
  }

  private void locate(double[] q) {
    forward.flange(q, flange12);
    Transforms.multiply(flange12, tool12, tcp12);
  }

  /**
   * Adds what the locks ask of the joints.
   *
   * @param q joint positions, rad
   * @param qd joint speeds, rad/s
   * @param torqueNm added to, Nm
   */
  void add(double[] q, double[] qd, double[] torqueNm) {
    if (count == 0) {
      return;
    }
    locate(q);
    jacobian.at(q, tcpInFlange, jacobian36);
    measure();
    weigh(q);
    MatrixVectorMult_DDRM.mult(rows, view(speed, qd), lockedSpeed);
    for (int k = 0; k < count; k++) {
      force.data[k] = acceleration(k);
    }
    if (!UnrolledCholesky_DDRM.lower(mobility, mobilityFactor)) {
      throw new IllegalStateException("the mobility is not positive: " + mobility);
    }
    TriangularSolver_DDRM.solveL(mobilityFactor.data, force.data, count);
    TriangularSolver_DDRM.solveTranL(mobilityFactor.data, force.data, count);
    MatrixVectorMult_DDRM.multAddTransA_reorder(rows, force, view(torque, torqueNm));
  }

  /** The matrix with the numbers of an array that is not copied. */
  private static DMatrixRMaj view(DMatrixRMaj matrix, double[] numbers) {
    matrix.setData(numbers);
    return matrix;
  }

  /** How far the tool centre point is from where it is kept, along each locked axis. */
  private void measure() {
    for (int k = 0; k < count; k++) {
      int axis = locked[k];
      if (axis < 3) {
        error[k] =
            along(axis, tcp12[9] - anchor3[0], tcp12[10] - anchor3[1], tcp12[11] - anchor3[2]);
        slip(k);
      } else {
        error[k] += along(axis - 3, turned(2, 1), turned(0, 2), turned(1, 0));
        error[k] = Math.clamp(error[k], -SLIP_RAD, SLIP_RAD);
      }
      integrate(k);
    }
    System.arraycopy(tcp12, 0, before12, 0, before12.length);
  }

  private void slip(int k) {
    double beyond = error[k] - Math.clamp(error[k], -SLIP_M, SLIP_M);
    if (beyond != 0) {
      error[k] -= beyond;
      for (int row = 0; row < 3; row++) {
        anchor3[row] += beyond * axes12[3 * row + locked[k]];
      }
    }
  }

  private void integrate(int k) {
    boolean straight = locked[k] < 3;
    double close = straight ? CLOSE_ENOUGH_M : CLOSE_ENOUGH_RAD;
    double slip = straight ? SLIP_M : SLIP_RAD;
    if (Math.abs(error[k]) > close) {
      double most = slip * SPRING / INTEGRAL;
      sum[k] = Math.clamp(sum[k] + FrameTime.FRAME_S * error[k], -most, most);
    }
  }

  /**
   * An element of the antisymmetric part of the rotation since the last frame: for angles this
   * small it is the rotation vector.
   */
  private double turned(int row, int other) {
    return (dot(tcp12, row, before12, other) - dot(tcp12, other, before12, row)) / 2;
  }

  private static double dot(double[] a, int rowOfA, double[] b, int rowOfB) {
    return a[3 * rowOfA] * b[3 * rowOfB]
        + a[3 * rowOfA + 1] * b[3 * rowOfB + 1]
        + a[3 * rowOfA + 2] * b[3 * rowOfB + 2];
  }

  private double along(int axis, double x, double y, double z) {
    return axes12[axis] * x + axes12[3 + axis] * y + axes12[6 + axis] * z;
  }

  /** Writes the rows of the locked axes, and the inverse of the mass along them. */
  private void weigh(double[] q) {
    for (int k = 0; k < count; k++) {
      int axis = locked[k] % 3;
      int from = locked[k] < 3 ? 0 : 3;
      for (int i = 0; i < N; i++) {
        rows.data[N * k + i] =
            along(
                axis,
                jacobian36[N * from + i],
                jacobian36[N * (from + 1) + i],
                jacobian36[N * (from + 2) + i]);
      }
    }
    model.mass(q, true, mass);
    if (!UnrolledCholesky_DDRM.lower(mass, massFactor)) {
      throw new IllegalStateException("the mass matrix is not positive: " + mass);
    }
    for (int k = 0; k < count; k++) {
      System.arraycopy(rows.data, N * k, column, 0, N);
      TriangularSolver_DDRM.solveL(massFactor.data, column, N);
      System.arraycopy(column, 0, moved.data, N * k, N);
    }
    CommonOps_DDRM.multOuter(moved, mobility);
    for (int k = 0; k < count; k++) {
      mobility.data[count * k + k] += locked[k] < 3 ? MIN_MOBILITY_PER_KG : MIN_MOBILITY_PER_KG_M2;
    }
  }

  private double acceleration(int k) {
    return -(SPRING * error[k] + DAMPER * lockedSpeed.data[k] + INTEGRAL * sum[k]);
  }
}
