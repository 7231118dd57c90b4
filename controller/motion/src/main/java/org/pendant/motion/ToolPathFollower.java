package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Tool path follower: turns points on a path of the TCP into joint positions, speeds and
 * accelerations.
 *
 * <p>Positions come from the closed inverse, continued from the last point. Speeds solve {@code J
 * qd = twist}; accelerations solve {@code J qdd = twist' - J' qd}, where the last term follows from
 * the columns (l, z) of J alone: each joint m adds {@code (2 w + z qd) x l qd} to its upper half
 * and {@code w x z qd} to its lower, {@code w} being the turning of the joints before it. (J.
 * Haviland and P. Corke, "Manipulator differential kinematics, part 2", IEEE Robotics and
 * Automation Magazine 2023, equations 8 to 12.)
 */
public final class ToolPathFollower {
  /** Damping of the solution that is tried in a singularity; see {@link #solve}. */
  private static final double DAMPING = 1e-4;

  /** Part of the twist that may be missed then: the path does not need the lost direction. */
  private static final double MISSED = 1e-5;

  private static final int N = Joints.COUNT;

  private final ToolCurve curve;
  private final Pose tcpInFlange;
  private final InverseKinematics inverse;
  private final Jacobian solver;
  private final double[] flangeInTcp = new double[Transforms.SIZE];
  private final double[] tcp = new double[Transforms.SIZE];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[][] frames = new double[N][Transforms.SIZE];
  private final double[] jacobian = new double[Jacobian.SIZE];
  private final double[] q = new double[N];
  private final double[] rate = new double[N];
  private final double[] bend = new double[N];
  private final double[] twist = new double[N];
  private final double[] given = new double[N];

  /**
   * Follows a curve.
   *
   * @param curve of the TCP in the base frame
   * @param from joint positions at its start, rad
   */
  public ToolPathFollower(ArmDescription arm, ToolCurve curve, Pose tcpInFlange, Joints from) {
    this.curve = curve;
    this.tcpInFlange = tcpInFlange;
    inverse = new InverseKinematics(arm);
    solver = new Jacobian(arm);
    double[] offset = new double[Transforms.SIZE];
    Transforms.of(tcpInFlange, offset);
    Transforms.invert(offset, flangeInTcp);
    from.copyTo(q);
  }

  /**
   * Continues from elsewhere, where the curve now leads.
   *
   * @param from joint positions there, rad
   */
  public void restart(Joints from) {
    from.copyTo(q);
  }

  /**
   * A point on the curve.
   *
   * @param at the curve's parameter
   * @param atPerS its first derivative by time, per s
   * @param atPerS2 its second derivative, per s²
   * @param sample overwritten
   */
  public Optional<MotionFailure> sample(
      double at, double atPerS, double atPerS2, MotionSample sample) {
    curve.at(at, tcp);
    Transforms.multiply(tcp, flangeInTcp, flange);
    if (!inverse.track(flange, q)) {
      return Optional.of(new MotionFailure(MotionFailure.OUT_OF_REACH, text("unreachablePoint")));
    }
    System.arraycopy(q, 0, sample.position, 0, N);
    if (atPerS == 0 && atPerS2 == 0) {
      sample.rest();
      return Optional.empty();
    }
    inverse.trackedFrames(q, frames);
    sample.setFrames(frames);
    solver.at(frames, tcpInFlange, jacobian);
    curve.rate(at, rate);
    for (int i = 0; i < N; i++) {
      twist[i] = rate[i] * atPerS;
    }
    boolean regular = solver.factorise(jacobian);
    if (!solve(regular, twist, sample.speed)) {
      return singular();
    }
    curve.bend(at, bend);
    for (int i = 0; i < N; i++) {
      twist[i] = rate[i] * atPerS2 + bend[i] * atPerS * atPerS;
    }
    subtractTurning(sample.speed);
    return solve(regular, twist, sample.acceleration) ? Optional.empty() : singular();
  }

  /** Subtracts J' qd from the twist. */
  private void subtractTurning(double[] qd) {
    double wx = 0;
    double wy = 0;
    double wz = 0;
    for (int m = 0; m < N; m++) {
      double turnX = jacobian[3 * N + m] * qd[m];
      double turnY = jacobian[4 * N + m] * qd[m];
      double turnZ = jacobian[5 * N + m] * qd[m];
      double lx = jacobian[m] * qd[m];
      double ly = jacobian[N + m] * qd[m];
      double lz = jacobian[2 * N + m] * qd[m];
      double ax = 2 * wx + turnX;
      double ay = 2 * wy + turnY;
      double az = 2 * wz + turnZ;
      twist[0] -= ay * lz - az * ly;
      twist[1] -= az * lx - ax * lz;
      twist[2] -= ax * ly - ay * lx;
      twist[3] -= wy * turnZ - wz * turnY;
      twist[4] -= wz * turnX - wx * turnZ;
      twist[5] -= wx * turnY - wy * turnX;
      wx += turnX;
      wy += turnY;
      wz += turnZ;
    }
  }

  /**
   * Joint rates for a twist. In a singularity there are some as long as the twist does not need the
   * direction that is lost, for instance when joint 5 stays at 0 all the way.
   */
  private boolean solve(boolean regular, double[] wanted, double[] rates) {
    if (regular) {
      solver.solve(wanted, rates);
      return true;
    }
    solver.solveDamped(jacobian, wanted, DAMPING, rates);
    Jacobian.twist(jacobian, rates, given);
    double size = 0;
    double missed = 0;
    for (int i = 0; i < N; i++) {
      size = Math.max(size, Math.abs(wanted[i]));
      missed = Math.max(missed, Math.abs(wanted[i] - given[i]));
    }
    return missed <= MISSED * size;
  }

  private static Optional<MotionFailure> singular() {
    return Optional.of(new MotionFailure(MotionFailure.SINGULARITY, text("throughSingularity")));
  }
}
