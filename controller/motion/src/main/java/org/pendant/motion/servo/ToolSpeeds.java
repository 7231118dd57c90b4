package org.pendant.motion.servo;

import java.util.OptionalDouble;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.StopL;
import org.pendant.motion.ToolPathFollower;

/**
 * Tool speed planner: makes motions that bring the TCP to a velocity. A program may ask for one
 * every frame, so they share one curve and one follower: only the newest motion may be sampled.
 */
final class ToolSpeeds {
  private static final int N = Joints.COUNT;

  private final ArmDescription arm;
  private final ForwardKinematics forward;
  private final Jacobian jacobian;
  private final TwistRamp ramp = new TwistRamp();
  private final double[] q = new double[N];
  private final double[] qd = new double[N];
  private final double[] matrix = new double[Jacobian.SIZE];
  private final double[] twist = new double[N];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] offset = new double[Transforms.SIZE];
  private final double[] tcp = new double[Transforms.SIZE];
  private ToolPathFollower follower;
  private Pose followedTool = Pose.ZERO;

  ToolSpeeds(ArmDescription arm) {
    this.arm = arm;
    forward = new ForwardKinematics(arm);
    jacobian = new Jacobian(arm);
    follower = new ToolPathFollower(arm, ramp, followedTool, Joints.ZERO);
    Transforms.of(followedTool, offset);
  }

  /**
   * A motion that replaces the one before.
   *
   * @param from joint positions at its start, rad
   * @param speed joint speeds there, rad/s
   * @param wanted velocity of the TCP in m/s and rad/s along the axes of the base
   */
  Motion motion(
      Joints from,
      Joints speed,
      Pose tcpInFlange,
      double[] wanted,
      double acceleration,
      double angularAcceleration,
      OptionalDouble returnS) {
    take(tcpInFlange);
    from.copyTo(q);
    speed.copyTo(qd);
    forward.flange(q, flange);
    Transforms.multiply(flange, offset, tcp);
    jacobian.at(q, tcpInFlange, matrix);
    Jacobian.twist(matrix, qd, twist);
    double rampS =
        Math.max(change(wanted, 0) / acceleration, change(wanted, 3) / angularAcceleration);
    ramp.begin(tcp, twist, wanted, rampS);
    follower.restart(from);
    MotionPlan ending =
        (q, qd) -> new StopL(arm, q, qd, tcpInFlange, acceleration, angularAcceleration);
    return new SpeedL(follower, rampS, returnS, ending);
  }

  private void take(Pose tcpInFlange) {
    if (!tcpInFlange.equals(followedTool)) {
      followedTool = tcpInFlange;
      follower = new ToolPathFollower(arm, ramp, tcpInFlange, Joints.ZERO);
      Transforms.of(tcpInFlange, offset);
    }
  }

  /** By how much three components of the twist have to change. */
  private double change(double[] wanted, int first) {
    double x = wanted[first] - twist[first];
    double y = wanted[first + 1] - twist[first + 1];
    double z = wanted[first + 2] - twist[first + 2];
    return Math.sqrt(x * x + y * y + z * z);
  }
}
