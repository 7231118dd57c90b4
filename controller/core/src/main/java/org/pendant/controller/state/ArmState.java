package org.pendant.controller.state;

import java.util.Optional;
import org.pendant.controller.box.ToolCentre;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionFailure;

/**
 * Arm state: where the arm should be and is. Poses are computed each time they are asked for;
 * {@link ArmGeometry} keeps them.
 *
 * @param targetPositionRad joint positions it is told
 * @param targetSpeedRadPerS joint speeds it is told
 * @param targetAccelerationRadPerS2 joint accelerations it is told
 * @param actualPositionRad joint positions
 * @param actualSpeedRadPerS joint speeds
 * @param tool the active tool centre point
 * @param description what the arm is made of
 * @param kinematics of the arm
 * @param controlMode what the drives follow
 * @param moving whether a motion is under way, a paused one included
 * @param steady whether the target has rested for 500 ms
 * @param speedFraction the speed slider, 0 to 1
 * @param speedScaling how fast motion time runs against the clock, 0 to 1
 * @param fault why the arm left its path and stopped since the last program start
 */
public record ArmState(
    Joints targetPositionRad,
    Joints targetSpeedRadPerS,
    Joints targetAccelerationRadPerS2,
    Joints actualPositionRad,
    Joints actualSpeedRadPerS,
    ToolCentre tool,
    ArmDescription description,
    ForwardKinematics kinematics,
    ControlMode controlMode,
    boolean moving,
    boolean steady,
    double speedFraction,
    double speedScaling,
    Optional<MotionFailure> fault) {
  /** Joints that turn more slowly than this may be said to do so by noise alone, rad/s. */
  private static final double NOISE_RAD_PER_S = 2e-3;

  /**
   * Whether it stands still: where it was told to stay, and its joints do not turn but for the
   * noise of what reads them.
   */
  public boolean rests() {
    return rests(steady, controlMode, actualSpeedRadPerS.maxAbsDifference(Joints.ZERO));
  }

  /** The same of an arm whose fastest joint turns so fast, rad/s. */
  static boolean rests(boolean steady, ControlMode mode, double fastestRadPerS) {
    return steady && mode == ControlMode.POSITION && fastestRadPerS < NOISE_RAD_PER_S;
  }

  /** The same with its joints read elsewhere. */
  public ArmState withActualPosition(Joints positionRad) {
    return new ArmState(
        targetPositionRad,
        targetSpeedRadPerS,
        targetAccelerationRadPerS2,
        positionRad,
        actualSpeedRadPerS,
        tool,
        description,
        kinematics,
        controlMode,
        moving,
        steady,
        speedFraction,
        speedScaling,
        fault);
  }

  /** Target pose of the TCP in the base frame. */
  public Pose targetTcpInBase() {
    return kinematics.tcpPose(targetPositionRad, tool.inFlange());
  }

  /** Actual pose of the TCP in the base frame. */
  public Pose actualTcpInBase() {
    return kinematics.tcpPose(actualPositionRad, tool.inFlange());
  }
}
