package org.pendant.motion.toolpath;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionControl;

/** Remote TCP speed: how fast a tool that stands still moves over the part on the flange. */
final class RemoteSpeed {
  private RemoteSpeed() {}

  /** The speed of the target, m/s: of the flange, taken at the place of the tool. */
  static double mPerS(
      ArmDescription arm, ForwardKinematics forward, MotionControl motion, Pose toolInBase) {
    Joints q = motion.pathPositionRad();
    double[] jacobian = new double[Jacobian.SIZE];
    double[] twist = new double[Pose.SIZE];
    new Jacobian(arm).at(q.toArray(), Pose.ZERO, jacobian);
    Jacobian.twist(jacobian, motion.pathSpeedRadPerS().toArray(), twist);
    Pose flange = forward.flangePose(q);
    double x = toolInBase.x() - flange.x();
    double y = toolInBase.y() - flange.y();
    double z = toolInBase.z() - flange.z();
    double vx = twist[0] + twist[4] * z - twist[5] * y;
    double vy = twist[1] + twist[5] * x - twist[3] * z;
    double vz = twist[2] + twist[3] * y - twist[4] * x;
    return Math.sqrt(vx * vx + vy * vy + vz * vz);
  }
}
