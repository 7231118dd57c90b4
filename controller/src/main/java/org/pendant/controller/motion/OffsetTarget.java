package org.pendant.controller.motion;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Where the joints are to be when offsets carry the TCP aside from its path. Speeds and
 * accelerations are differences between frames.
 */
final class OffsetTarget {
  private static final int N = Joints.COUNT;

  private final List<PathOffset> offsets = new ArrayList<>();
  private final ForwardKinematics forward;
  private final InverseKinematics inverse;
  private final double[] q = new double[N];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] tcp = new double[Transforms.SIZE];
  private final double[] tcpInFlange = new double[Transforms.SIZE];
  private final double[] flangeInTcp = new double[Transforms.SIZE];
  private boolean engaged;
  private Joints position = Joints.ZERO;
  private Joints speed = Joints.ZERO;
  private Joints acceleration = Joints.ZERO;

  OffsetTarget(ArmDescription arm) {
    forward = new ForwardKinematics(arm.dh());
    inverse = new InverseKinematics(arm);
    setTool(Pose.ZERO);
  }

  /** The offset that is applied after those added before. */
  void add(PathOffset offset) {
    offsets.add(offset);
  }

  void setTool(Pose inFlange) {
    Transforms.of(inFlange, tcpInFlange);
    Transforms.invert(tcpInFlange, flangeInTcp);
  }

  /** Whether the target is not the path itself. */
  boolean engaged() {
    return engaged;
  }

  Joints position() {
    return position;
  }

  Joints speed() {
    return speed;
  }

  Joints acceleration() {
    return acceleration;
  }

  /**
   * The next target.
   *
   * @param path where the path is, rad
   * @param pathSpeed how fast it goes there, rad/s; taken over when offsets begin
   */
  Optional<MotionFailure> step(Joints path, Joints pathSpeed) {
    if (!anyActive()) {
      engaged = false;
      return Optional.empty();
    }
    if (!engaged) {
      engaged = true;
      position = path;
      speed = pathSpeed;
    }
    path.copyTo(q);
    forward.flange(q, flange);
    Transforms.multiply(flange, tcpInFlange, tcp);
    for (int i = 0; i < offsets.size(); i++) {
      if (offsets.get(i).active()) {
        offsets.get(i).apply(tcp);
      }
    }
    Transforms.multiply(tcp, flangeInTcp, flange);
    position.copyTo(q);
    if (!inverse.track(flange, q)) {
      return Optional.of(
          new MotionFailure("no-solution", "an offset takes the tool out of the arm's reach"));
    }
    Joints next = Joints.of(q);
    Joints nextSpeed = perSecond(position, next);
    acceleration = perSecond(speed, nextSpeed);
    speed = nextSpeed;
    position = next;
    return Optional.empty();
  }

  private static Joints perSecond(Joints before, Joints after) {
    double f = 1 / FrameTime.FRAME_S;
    return new Joints(
        (after.q0() - before.q0()) * f,
        (after.q1() - before.q1()) * f,
        (after.q2() - before.q2()) * f,
        (after.q3() - before.q3()) * f,
        (after.q4() - before.q4()) * f,
        (after.q5() - before.q5()) * f);
  }

  private boolean anyActive() {
    for (int i = 0; i < offsets.size(); i++) {
      if (offsets.get(i).active()) {
        return true;
      }
    }
    return false;
  }

  /** Nothing is carried any more. */
  void end() {
    engaged = false;
    offsets.forEach(PathOffset::end);
  }
}
