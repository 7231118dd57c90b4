package org.pendant.controller.arm;

import java.util.Arrays;
import org.pendant.controller.world.ContactWorld;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.pose.Wrench;
import org.pendant.models.time.FrameTime;

/**
 * External forces on the tool: the wrench at the flange and the torques that it causes at the
 * joints.
 */
final class ExternalForces {
  private static final int N = Joints.COUNT;

  /** Wrench at the flange's origin along the base's axes, N and Nm. */
  final double[] wrench6 = new double[6];

  /** The joint torques that it is worth, Nm. */
  final double[] torqueNm = new double[N];

  private final ContactWorld world;
  private final ForwardKinematics forward;
  private final Jacobian jacobian;
  private final double[] jacobian36 = new double[Jacobian.SIZE];
  private final double[] tcpInFlange3 = new double[3];
  private final double[] ahead = new double[N];
  private final double[] flange12 = new double[Transforms.SIZE];
  private final double[] twist6 = new double[6];
  private final double[][] linkFrames = new double[N][Transforms.SIZE];
  private final HandForces grip;
  private Wrench applied;
  private long gripChange;

  ExternalForces(ArmDescription arm, ContactWorld world) {
    this.world = world;
    forward = new ForwardKinematics(arm);
    jacobian = new Jacobian(arm);
    grip = new HandForces(world.grip(), arm, forward);
    applied = world.applied();
    gripChange = world.grip().changes();
  }

  void setToolCentre(Pose tcpInFlange) {
    tcpInFlange3[0] = tcpInFlange.x();
    tcpInFlange3[1] = tcpInFlange.y();
    tcpInFlange3[2] = tcpInFlange.z();
    world.setToolCentre(tcpInFlange);
  }

  /**
   * Feels what will push at the end of the frame if the arm continues as now. {@link #feel} uses
   * the same levers within the frame.
   */
  void lookAhead(ArmBody body) {
    applied = world.applied();
    gripChange = world.grip().changes();
    if (world.pushesNothing()) {
      Arrays.fill(wrench6, 0);
      Arrays.fill(torqueNm, 0);
      return;
    }
    predictFrame(body.q, body.qd, FrameTime.FRAME_S);
    if (!world.shared()) {
      placeLinks(body.qd);
      world.advance(flange12, tcpInFlange3, twist6, FrameTime.FRAME_S);
    }
    feelAhead(body);
  }

  private void predictFrame(double[] q, double[] qd, double afterS) {
    predict(q, qd, afterS);
    jacobian.at(ahead, Pose.ZERO, jacobian36);
    moveFlange(qd);
  }

  private void placeLinks(double[] qd) {
    if (world.hasFreeBodies()) {
      forward.frames(ahead, linkFrames);
      world.moveLinks(linkFrames, qd);
    }
  }

  /** Says to a world that other arms share where the arm will be at the end of the frame. */
  void place(double[] q, double[] qd) {
    if (world.shared() && world.hasFreeBodies()) {
      predictFrame(q, qd, FrameTime.FRAME_S);
      placeLinks(qd);
      world.place(flange12, tcpInFlange3, twist6);
    }
  }

  /**
   * Lets the objects of a world of one arm move around it while nothing acts back on it.
   *
   * @param q where it is at the end of the frame, rad
   * @param qd how it moves then, rad/s
   */
  void moveBodies(double[] q, double[] qd) {
    predictFrame(q, qd, 0);
    placeLinks(qd);
    world.advance(flange12, tcpInFlange3, twist6, FrameTime.FRAME_S);
  }

  /** Takes what objects that have a mass do to the tool, and nothing else. */
  void feelBodies() {
    world.bodyWrench(wrench6);
  }

  /** Feels what will push {@code afterS} s later if the arm continues as now. */
  void feel(ArmBody body, double afterS) {
    predict(body.q, body.qd, afterS);
    moveFlange(body.qd);
    feelAhead(body);
  }

  private void predict(double[] q, double[] qd, double afterS) {
    for (int i = 0; i < N; i++) {
      ahead[i] = q[i] + afterS * qd[i];
    }
  }

  private void moveFlange(double[] qd) {
    forward.flange(ahead, flange12);
    Jacobian.twist(jacobian36, qd, twist6);
  }

  private void feelAhead(ArmBody body) {
    world.wrench(flange12, tcpInFlange3, twist6, wrench6);
    Jacobian.transposed(jacobian36, wrench6, torqueNm);
    world.addLinkTorques(torqueNm);
    grip.add(ahead, body.qd, torqueNm, wrench6);
  }

  /** Whether the tool touched something when it was felt for last. */
  boolean inContact() {
    return world.inContact();
  }

  /** Sets the acceleration that bodies at rest feel, m/s², along the axes of the base. */
  void setMounting(double x, double y, double z) {
    world.setGravity(-x, -y, -z);
  }

  /** Whether a hand pushes otherwise than was felt last, or something around the arm moves. */
  boolean changed() {
    return world.bodiesMove()
        || !world.applied().equals(applied)
        || world.grip().changes() != gripChange;
  }
}
