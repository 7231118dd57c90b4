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
    predictFrame(body);
    if (!world.shared()) {
      placeLinks(body);
      world.advance(flange12, tcpInFlange3, twist6, FrameTime.FRAME_S);
    }
    feelAhead(body);
  }

  private void predictFrame(ArmBody body) {
    predict(body, FrameTime.FRAME_S);
    jacobian.at(ahead, Pose.ZERO, jacobian36);
    moveFlange(body);
  }

  private void placeLinks(ArmBody body) {
    if (world.hasFreeBodies()) {
      forward.frames(ahead, linkFrames);
      world.moveLinks(linkFrames, body.qd);
    }
  }

  /** Says to a world that other arms share where the arm will be at the end of the frame. */
  void place(ArmBody body) {
    if (world.shared() && world.hasFreeBodies()) {
      predictFrame(body);
      placeLinks(body);
      world.place(flange12, tcpInFlange3, twist6);
    }
  }

  /** Feels what will push {@code afterS} s later if the arm continues as now. */
  void feel(ArmBody body, double afterS) {
    predict(body, afterS);
    moveFlange(body);
    feelAhead(body);
  }

  private void predict(ArmBody body, double afterS) {
    for (int i = 0; i < N; i++) {
      ahead[i] = body.q[i] + afterS * body.qd[i];
    }
  }

  private void moveFlange(ArmBody body) {
    forward.flange(ahead, flange12);
    Jacobian.twist(jacobian36, body.qd, twist6);
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
