package org.pendant.motion.force;

import java.util.Arrays;
import java.util.function.Supplier;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionControl;
import org.pendant.motion.PathLimiter;

/**
 * Compliance limiter: keeps the compliant motion of force mode within the limits of the joints. It
 * slows the motion down, or ends it, before a joint exceeds its speed, range or torque, or the arm
 * reaches a singularity.
 */
final class ComplianceLimiter {
  /** How fast joints change their speeds to give way, rad/s². */
  private static final double ACCELERATION_RAD_PER_S2 = 15;

  /** The last bit of a joint's range is not used, rad. */
  private static final double MARGIN_RAD = 0.01;

  /** Speed allowed for each rad that is left of a joint's range, 1/s. */
  private static final double WALL_PER_S = 4;

  /** Speed of the joints allowed for each 1 of a singularity's measure, rad/s. */
  private static final double SINGULARITY_RAD_PER_S = 8;

  /** A joint that cannot follow its target any better than this presses no harder, rad. */
  private static final double MAX_LEAD_RAD = 0.03;

  /** Looks in the search for a speed that is allowed. */
  private static final int CHORDS = 3;

  /** What the search aims at, a rounding below all that is allowed, and what is near enough. */
  private static final double AIM = 1 - 1e-9;

  private static final double ENOUGH = 0.99;

  private static final Singularity[] SINGULARITIES = Singularity.values();
  private static final int N = Joints.COUNT;

  private final DhLengths dh;
  private final double[] minRad = new double[N];
  private final double[] maxRad = new double[N];
  private final PathLimiter speeds;
  private final Supplier<? extends JointPositionLimits> limits;
  private final MeasuredArm measured;
  private final ForwardKinematics forward;
  private final Jacobian jacobian;
  private final double[][] frames = new double[N][Transforms.SIZE];
  private final double[] jacobian36 = new double[Jacobian.SIZE];
  private final double[] q = new double[N];
  private final double[] actual = new double[N];
  private final double[] path = new double[N];
  private final double[] wanted = new double[N];
  private final double[] speed = new double[N];
  private final double[] sum = new double[N];

  /** The share that was searched last. */
  private double found;

  /**
   * For an arm that stands still.
   *
   * @param speeds knows how fast the arm may go
   * @param limits the safety limits that hold now
   * @param measured says where the arm truly is
   */
  ComplianceLimiter(
      ArmDescription arm,
      PathLimiter speeds,
      Supplier<? extends JointPositionLimits> limits,
      MeasuredArm measured) {
    dh = arm.dh();
    for (int i = 0; i < N; i++) {
      minRad[i] = arm.joints().get(i).lowestRad();
      maxRad[i] = arm.joints().get(i).highestRad();
    }
    this.measured = measured;
    this.speeds = speeds;
    this.limits = limits;
    forward = new ForwardKinematics(arm);
    jacobian = new Jacobian(arm);
  }

  /**
   * Comes as near to a velocity as it may.
   *
   * @param motion knows where the joints are to be
   * @param tcpInFlange the TCP that is carried
   * @param pathTwist6 how the path moves it, m/s and rad/s along the axes of the base
   * @param twist6 its velocity besides so far, along the same axes
   * @param next6 the velocity wanted instead; overwritten with the possible one
   */
  void limit(
      MotionControl motion,
      Pose tcpInFlange,
      double[] pathTwist6,
      double[] twist6,
      double[] next6) {
    motion.copyPositionRad(q);
    forward.frames(q, frames);
    jacobian.at(frames, tcpInFlange, jacobian36);
    if (!jacobian.factorise(jacobian36)) {
      Arrays.fill(next6, 0);
      return;
    }
    jacobian.solve(twist6, speed);
    jacobian.solve(next6, wanted);
    jacobian.solve(pathTwist6, path);
    double answered = accelerationShare();
    for (int i = 0; i < N; i++) {
      speed[i] += answered * (wanted[i] - speed[i]);
    }
    double share = Math.min(singularityShare(), Math.min(wallShare(), leadShare()));
    double kept = allowed(share);
    // the share of joint speeds is that of the velocity: no other axis begins to move
    for (int i = 0; i < N; i++) {
      next6[i] = kept * (answered == 1 ? next6[i] : twist6[i] + answered * (next6[i] - twist6[i]));
    }
  }

  private double accelerationShare() {
    double largest = 0;
    for (int i = 0; i < N; i++) {
      largest = Math.max(largest, Math.abs(wanted[i] - speed[i]));
    }
    double step = ACCELERATION_RAD_PER_S2 * FrameTime.FRAME_S;
    return largest > step ? step / largest : 1;
  }

  private double singularityShare() {
    double measure = 1;
    for (Singularity each : SINGULARITIES) {
      measure = Math.min(measure, each.measure(dh, q));
    }
    double fastest = 0;
    for (double each : speed) {
      fastest = Math.max(fastest, Math.abs(each));
    }
    return Math.min(1, SINGULARITY_RAD_PER_S * measure / fastest);
  }

  private double wallShare() {
    JointPositionLimits safe = limits.get();
    double share = 1;
    for (int i = 0; i < N; i++) {
      double room =
          speed[i] > 0
              ? Math.min(maxRad[i], safe.jointMaxRad().get(i)) - q[i]
              : q[i] - Math.max(minRad[i], safe.jointMinRad().get(i));
      double most = WALL_PER_S * Math.max(0, room - MARGIN_RAD) - path[i] * Math.signum(speed[i]);
      if (Math.abs(speed[i]) > most) {
        share = Math.min(share, Math.max(0, most) / Math.abs(speed[i]));
      }
    }
    return share;
  }

  /** A target that runs away from an arm that cannot press any harder would only be a stop. */
  private double leadShare() {
    measured.copyPositionRad(actual);
    double share = 1;
    for (int i = 0; i < N; i++) {
      double lead = (q[i] - actual[i]) * Math.signum(speed[i]);
      share = Math.min(share, 2 - 2 * lead / MAX_LEAD_RAD);
    }
    return Math.max(0, share);
  }

  /**
   * A share, up to {@code most}, with which no speed of the arm is too high, and the largest such
   * as near as a few looks find it. What speeds demand is the size of a vector that changes evenly
   * with the share, so a chord runs above it, and where the chord reaches the limit all is well.
   */
  private double allowed(double most) {
    double beyond = demand(most);
    if (beyond <= 1) {
      return most;
    }
    double high = most;
    double low = 0;
    double beneath = 0;
    if (found > 0 && found < most) {
      // most frames are like the one before
      double there = demand(found);
      if (there <= 1) {
        low = found;
        beneath = there;
      } else {
        high = found;
        beyond = there;
      }
    }
    if (low == 0) {
      beneath = demand(0);
    }
    for (int i = 0; i < CHORDS && beneath < ENOUGH; i++) {
      double between = low + (high - low) * (AIM - beneath) / (beyond - beneath);
      double there = demand(between);
      if (there <= 1) {
        low = between;
        beneath = there;
      } else {
        high = between;
        beyond = there;
      }
    }
    found = low;
    return low;
  }

  /** What a share of the speeds is of what the arm may do; at most 1 is allowed. */
  private double demand(double share) {
    for (int i = 0; i < N; i++) {
      sum[i] = path[i] + share * speed[i];
    }
    return 1 / speeds.largestScaling(q, sum, frames);
  }
}
