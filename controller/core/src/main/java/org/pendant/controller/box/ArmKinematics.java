package org.pendant.controller.box;

import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionControl;

/** Kinematics of the arm of a control box, and of its tool where it is and where it should be. */
public final class ArmKinematics {
  private final ForwardKinematics forward;
  private final InverseKinematics inverse;
  private final Jacobian jacobian;
  private final ToolFlange flange;
  private final MotionControl motion;
  private final ArmDrive drive;

  /**
   * Kinematics of an arm.
   *
   * @param flange has the active TCP
   * @param motion has the target of the joints
   * @param drive has their actual positions
   */
  ArmKinematics(ArmDescription arm, ToolFlange flange, MotionControl motion, ArmDrive drive) {
    forward = new ForwardKinematics(arm);
    inverse = new InverseKinematics(arm);
    jacobian = new Jacobian(arm);
    this.flange = flange;
    this.motion = motion;
    this.drive = drive;
  }

  /** Forward kinematics of the arm. */
  public ForwardKinematics forward() {
    return forward;
  }

  /** Inverse kinematics of the arm. */
  public InverseKinematics inverse() {
    return inverse;
  }

  /** The Jacobian of the arm; keeps scratch space, so only for the frame loop. */
  public Jacobian jacobian() {
    return jacobian;
  }

  /** Target pose of the TCP in the base frame. */
  public Pose targetTcpInBase() {
    return forward.tcpPose(motion.positionRad(), flange.tool().inFlange());
  }

  /** Actual pose of the TCP in the base frame. */
  public Pose actualTcpInBase() {
    return forward.tcpPose(drive.actualPositionRad(), flange.tool().inFlange());
  }

  /**
   * Velocity of the TCP in m/s and its angular velocity in rad/s, both along the axes of the base.
   *
   * @param positionRad joint positions
   * @param speedRadPerS joint speeds
   */
  public Pose tcpTwistInBase(Joints positionRad, Joints speedRadPerS) {
    double[] matrix = new double[Jacobian.SIZE];
    double[] twist = new double[Pose.SIZE];
    jacobian.at(positionRad.toArray(), flange.tool().inFlange(), matrix);
    Jacobian.twist(matrix, speedRadPerS.toArray(), twist);
    return Pose.of(twist);
  }
}
