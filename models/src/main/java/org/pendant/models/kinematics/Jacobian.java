package org.pendant.models.kinematics;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * The geometric Jacobian: joint speeds to the twist of the TCP (manual 16.17), and back; and its
 * time derivative (manual 16.18).
 *
 * <p>A twist is six numbers, the velocity of the TCP's origin in m/s, then the angular velocity in
 * rad/s, both along the axes of the base frame. Column i of the Jacobian is what joint i alone
 * gives at 1 rad/s: {@code (z x (p_tcp - p), z)} for an axis z through p. (B. Siciliano et al.,
 * "Robotics: Modelling, Planning and Control", equation 3.30.)
 *
 * <p>A matrix is a {@code double[36]}, its rows one after another. Methods write into their last
 * parameter and allocate nothing. An object keeps scratch space between calls: it must not be used
 * by two threads at once.
 */
public final class Jacobian {
  /** Numbers in a Jacobian. */
  public static final int SIZE = Joints.COUNT * Joints.COUNT;

  private static final int N = Joints.COUNT;

  private final ForwardKinematics forward;
  private final double[][] frames = new double[N][Transforms.SIZE];
  private final double[] tcp = new double[3];
  private final SpeedSolver solver = new SpeedSolver();

  /** The Jacobian of an arm, its calibration included. */
  public Jacobian(ArmDescription arm) {
    forward = new ForwardKinematics(arm);
  }

  /**
   * The Jacobian at joint positions {@code q}.
   *
   * @param q six joint positions, rad
   * @param tcpInFlange the TCP offset; only its position matters
   * @param jacobian 36 numbers, overwritten
   */
  public void at(double[] q, Pose tcpInFlange, double[] jacobian) {
    forward.frames(q, frames);
    at(frames, tcpInFlange, jacobian);
  }

  /**
   * The Jacobian where the links are in known frames.
   *
   * @param linkFrames six rows of twelve numbers, as {@link ForwardKinematics#frames} has them
   * @param tcpInFlange the TCP offset; only its position matters
   * @param jacobian 36 numbers, overwritten
   */
  public void at(double[][] linkFrames, Pose tcpInFlange, double[] jacobian) {
    double[] flange = linkFrames[N - 1];
    for (int axis = 0; axis < 3; axis++) {
      tcp[axis] = flange[9 + axis] + turned(flange, 3 * axis, tcpInFlange);
    }
    column(0, 0, 1, tcp[0], tcp[1], tcp[2], 0, jacobian);
    for (int i = 1; i < N; i++) {
      double[] before = linkFrames[i - 1];
      column(
          before[2],
          before[5],
          before[8],
          tcp[0] - before[9],
          tcp[1] - before[10],
          tcp[2] - before[11],
          i,
          jacobian);
    }
  }

  /**
   * The twist that joint speeds give.
   *
   * @param jacobian 36 numbers
   * @param qd six joint speeds, rad/s
   * @param twist six numbers, overwritten; must not be {@code qd}
   */
  public static void twist(double[] jacobian, double[] qd, double[] twist) {
    for (int row = 0; row < N; row++) {
      twist[row] = row(jacobian, row, qd);
    }
  }

  /**
   * The time derivative of the Jacobian while the joints move (manual 16.18): times the joint
   * speeds it is the part of the TCP's acceleration that needs no joint acceleration.
   *
   * <p>By the product rule, column i is {@code (zd x r + z x rd, zd)} with r the arm from axis i to
   * the TCP; an axis turns with the link that carries it: {@code zd = omega x z}.
   *
   * @param q six joint positions, rad
   * @param qd six joint speeds, rad/s
   * @param tcpInFlange the TCP offset; only its position matters
   * @param derivative 36 numbers, per second, overwritten
   */
  public void derivative(double[] q, double[] qd, Pose tcpInFlange, double[] derivative) {
    at(q, tcpInFlange, derivative);
    double tcpSpeedX = row(derivative, 0, qd);
    double tcpSpeedY = row(derivative, 1, qd);
    double tcpSpeedZ = row(derivative, 2, qd);
    // of the link before joint i: angular velocity, and velocity of its frame's origin on axis i
    double wx = 0;
    double wy = 0;
    double wz = 0;
    double vx = 0;
    double vy = 0;
    double vz = 0;
    for (int i = 0; i < N; i++) {
      double zx = derivative[3 * N + i];
      double zy = derivative[4 * N + i];
      double zz = derivative[5 * N + i];
      double zdx = wy * zz - wz * zy;
      double zdy = wz * zx - wx * zz;
      double zdz = wx * zy - wy * zx;
      double rx = tcp[0] - origin(i, 9);
      double ry = tcp[1] - origin(i, 10);
      double rz = tcp[2] - origin(i, 11);
      double rdx = tcpSpeedX - vx;
      double rdy = tcpSpeedY - vy;
      double rdz = tcpSpeedZ - vz;
      derivative[i] = zdy * rz - zdz * ry + zy * rdz - zz * rdy;
      derivative[N + i] = zdz * rx - zdx * rz + zz * rdx - zx * rdz;
      derivative[2 * N + i] = zdx * ry - zdy * rx + zx * rdy - zy * rdx;
      derivative[3 * N + i] = zdx;
      derivative[4 * N + i] = zdy;
      derivative[5 * N + i] = zdz;
      wx += zx * qd[i];
      wy += zy * qd[i];
      wz += zz * qd[i];
      double linkX = frames[i][9] - origin(i, 9);
      double linkY = frames[i][10] - origin(i, 10);
      double linkZ = frames[i][11] - origin(i, 11);
      vx += wy * linkZ - wz * linkY;
      vy += wz * linkX - wx * linkZ;
      vz += wx * linkY - wy * linkX;
    }
  }

  /**
   * The joint torques that a wrench on the TCP is worth, the Jacobian transposed times it. Motors
   * that hold the arm against the wrench give the opposite.
   *
   * @param jacobian 36 numbers
   * @param wrench force in N at the TCP and torque in Nm about it, along the axes of the base
   * @param torque six joint torques in Nm, overwritten; must not be {@code wrench}
   */
  public static void transposed(double[] jacobian, double[] wrench, double[] torque) {
    for (int i = 0; i < N; i++) {
      double sum = 0;
      for (int row = 0; row < N; row++) {
        sum += jacobian[N * row + i] * wrench[row];
      }
      torque[i] = sum;
    }
  }

  /**
   * The joint speeds that give a twist, by elimination with row pivoting.
   *
   * @param jacobian 36 numbers
   * @param twist six numbers
   * @param qd six joint speeds in rad/s, overwritten
   * @return false if the arm is singular; {@code qd} is then undefined
   */
  public boolean solve(double[] jacobian, double[] twist, double[] qd) {
    if (!factorise(jacobian)) {
      return false;
    }
    solve(twist, qd);
    return true;
  }

  /**
   * Takes a matrix to solve for several twists: {@link #solve(double[], double[])} answers for it
   * until another one is taken, or {@link #solveDamped} is called.
   *
   * @param jacobian 36 numbers
   * @return false if the arm is singular; there is then nothing to solve
   */
  public boolean factorise(double[] jacobian) {
    return solver.factorise(jacobian);
  }

  /**
   * As {@link #solve(double[], double[], double[])} for the matrix that {@link #factorise} has
   * taken.
   *
   * @param twist six numbers
   * @param qd six joint speeds in rad/s, overwritten; must not be {@code twist}
   */
  public void solve(double[] twist, double[] qd) {
    solver.solve(twist, qd);
  }

  /**
   * The joint speeds that come nearest to a twist while staying moderate: the least {@code |J qd -
   * twist|^2 + damping^2 |qd|^2}. Unlike {@link #solve} it passes through singularities; away from
   * them it differs from it by about the square of damping over the smallest singular value.
   *
   * @param jacobian 36 numbers
   * @param twist six numbers
   * @param damping above 0; 0.01 to 0.1 is usual
   * @param qd six joint speeds in rad/s, overwritten; must not be {@code twist}
   * @throws IllegalArgumentException if damping is not above 0
   */
  public void solveDamped(double[] jacobian, double[] twist, double damping, double[] qd) {
    if (!(damping > 0)) {
      throw new IllegalArgumentException("jacobian: damping is " + damping + ", must be above 0");
    }
    solver.solveDamped(jacobian, twist, damping, qd);
  }

  private static double row(double[] matrix, int row, double[] qd) {
    double sum = 0;
    for (int i = 0; i < N; i++) {
      sum += matrix[N * row + i] * qd[i];
    }
    return sum;
  }

  /** Coordinate (9 to 11) of the origin of the frame before joint i, a point of its axis. */
  private double origin(int i, int coordinate) {
    return i == 0 ? 0 : frames[i - 1][coordinate];
  }

  private static double turned(double[] transform, int row, Pose offset) {
    return transform[row] * offset.x()
        + transform[row + 1] * offset.y()
        + transform[row + 2] * offset.z();
  }

  /** Writes column i: axis z, and the arm (x, y, z) from the axis to the TCP. */
  private static void column(
      double zx, double zy, double zz, double x, double y, double z, int i, double[] jacobian) {
    jacobian[i] = zy * z - zz * y;
    jacobian[N + i] = zz * x - zx * z;
    jacobian[2 * N + i] = zx * y - zy * x;
    jacobian[3 * N + i] = zx;
    jacobian[4 * N + i] = zy;
    jacobian[5 * N + i] = zz;
  }
}
