package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.StraightLine;

/**
 * Linear stop: the tool slows down to rest and keeps its direction, turning included (manual
 * 15.52).
 */
public final class StopL implements Motion {
  /** Largest angle (rad) between the ends of the line the stop is laid on; it is then extended. */
  private static final double LINE_ANGLE_RAD = 1;

  private final ToolPathFollower follower;
  private final double durationS;

  /** Time at the initial speed from one end of the line to the other, s. */
  private final double lineS;

  /**
   * Plans a stop.
   *
   * @param positionRad joint positions at its start, rad
   * @param speedRadPerS joint speeds at its start, rad/s
   * @param tcpInFlange the TCP offset
   * @param decelerationMPerS2 of the TCP, m/s², above 0
   * @param angularDecelerationRadPerS2 of the tool's turning, rad/s², above 0; the slower of the
   *     two decides for both
   */
  public StopL(
      ArmDescription arm,
      Joints positionRad,
      Joints speedRadPerS,
      Pose tcpInFlange,
      double decelerationMPerS2,
      double angularDecelerationRadPerS2) {
    double[] jacobian = new double[Jacobian.SIZE];
    double[] twist = new double[Joints.COUNT];
    new Jacobian(arm).at(positionRad.toArray(), tcpInFlange, jacobian);
    Jacobian.twist(jacobian, speedRadPerS.toArray(), twist);
    double speed = length(twist[0], twist[1], twist[2]);
    double turning = length(twist[3], twist[4], twist[5]);
    durationS = Math.max(speed / decelerationMPerS2, turning / angularDecelerationRadPerS2);
    lineS = Math.min(0.5 * durationS, LINE_ANGLE_RAD / turning);
    Pose start = new ForwardKinematics(arm).tcpPose(positionRad, tcpInFlange);
    Pose advance =
        new Pose(
            twist[0] * lineS,
            twist[1] * lineS,
            twist[2] * lineS,
            twist[3] * lineS,
            twist[4] * lineS,
            twist[5] * lineS);
    StraightLine line = new StraightLine(start, Poses.add(advance, start));
    follower = new ToolPathFollower(arm, new ToolLine(line, 1), tcpInFlange, positionRad);
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }

  @Override
  public double durationS() {
    return durationS;
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (durationS == 0) {
      return follower.sample(0, 0, 0, sample);
    }
    double left = durationS - timeS;
    double travelledS = 0.5 * (durationS - left * left / durationS);
    return follower.sample(
        travelledS / lineS,
        left / durationS / lineS,
        left > 0 ? -1 / durationS / lineS : 0,
        sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
