package org.pendant.controller.state;

import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Tool motion: how the TCP and the elbow move while the joints turn; everything in the base frame.
 * The elbow is the end of the upper arm, the origin of Denavit-Hartenberg frame 2.
 *
 * @param speed of the TCP, m/s, and angular velocity, rad/s
 * @param acceleration of the TCP, m/s², and angular acceleration, rad/s²
 * @param elbowM where the elbow is, m
 * @param elbowSpeedMPerS how fast the elbow moves, m/s
 */
public record ToolMotion(Pose speed, Pose acceleration, Vector3 elbowM, Vector3 elbowSpeedMPerS) {
  private static final int ELBOW = 1;

  /**
   * Follows the joints from the base to the tool.
   *
   * @param q joint positions, rad
   * @param qd joint speeds, rad/s
   * @param qdd joint accelerations, rad/s²
   */
  public static ToolMotion of(
      ForwardKinematics kinematics, Joints q, Joints qd, Joints qdd, Pose tcpInFlange) {
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    kinematics.frames(q.toArray(), frames);
    LinkMotion link = new LinkMotion();
    Vector3 elbowM = new Vector3(0, 0, 0);
    Vector3 elbowSpeed = elbowM;
    for (int i = 0; i < Joints.COUNT; i++) {
      link.turn(i, frames, qd.get(i), qdd.get(i));
      link.goTo(frames[i][9], frames[i][10], frames[i][11]);
      if (i == ELBOW) {
        elbowM = link.place();
        elbowSpeed = link.velocity();
      }
    }
    link.goTo(frames[Joints.COUNT - 1], tcpInFlange.x(), tcpInFlange.y(), tcpInFlange.z());
    return new ToolMotion(link.twist(), link.acceleration(), elbowM, elbowSpeed);
  }
}
