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
  private final JointSpeedCheck jointSpeeds;
  private final OffsetHold hold = new OffsetHold();
  private final double[] q = new double[N];
  private final double[] flange = new double[Transforms.SIZE];
  private final double[] tcp = new double[Transforms.SIZE];
  private final double[] tcpInFlange = new double[Transforms.SIZE];
  private final double[] flangeInTcp = new double[Transforms.SIZE];
  private boolean engaged;
  private Joints before = Joints.ZERO;
  private Joints position = Joints.ZERO;
  private Joints speed = Joints.ZERO;
  private Joints acceleration = Joints.ZERO;

  OffsetTarget(ArmDescription arm, JointSpeedCheck jointSpeeds) {
    this.jointSpeeds = jointSpeeds;
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
   * @return why there is none; the target is what it was then
   */
  Optional<MotionFailure> step(Joints path, Joints pathSpeed) {
    if (!anyActive()) {
      engaged = false;
      hold.clear();
      return Optional.empty();
    }
    if (!engaged) {
      engaged = true;
      position = path;
      speed = pathSpeed;
    }
    if (hold.holding()) {
      hold.step(position, speed, q);
      accept(Joints.of(q));
      return Optional.empty();
    }
    path.copyTo(q);
    toTcp();
    for (int i = 0; i < offsets.size(); i++) {
      if (offsets.get(i).active()) {
        offsets.get(i).apply(tcp);
      }
    }
    if (!solveNear(position)) {
      return Optional.of(
          new MotionFailure("no-solution", "an offset takes the tool out of the arm's reach"));
    }
    hold.leadBack(position, q);
    Joints next = Joints.of(q);
    Optional<MotionFailure> failure = jointSpeeds.carried(perSecond(position, next));
    if (failure.isEmpty()) {
      accept(next);
    }
    return failure;
  }

  private void accept(Joints next) {
    Joints nextSpeed = perSecond(position, next);
    acceleration = perSecond(speed, nextSpeed);
    speed = nextSpeed;
    before = position;
    position = next;
  }

  private void toTcp() {
    forward.flange(q, flange);
    Transforms.multiply(flange, tcpInFlange, tcp);
  }

  private boolean solveNear(Joints near) {
    Transforms.multiply(tcp, flangeInTcp, flange);
    near.copyTo(q);
    return inverse.track(flange, q);
  }

  /**
   * The path anew, so that those offsets that are still active carry it to where the target is.
   *
   * @param path where it has been, rad
   * @return positions, rad, and speeds, rad/s; empty if it would be out of reach
   */
  Optional<Rebased> rebased(Joints path) {
    if (!anyActive()) {
      return Optional.of(new Rebased(position, speed));
    }
    Optional<Joints> last = rebased(position, path, 0);
    Optional<Joints> earlier = rebased(before, path, 1);
    return last.isPresent() && earlier.isPresent()
        ? Optional.of(new Rebased(last.get(), perSecond(earlier.get(), last.get())))
        : Optional.empty();
  }

  /** A path that the target stays where it is with. */
  record Rebased(Joints positionRad, Joints speedRadPerS) {}

  private Optional<Joints> rebased(Joints target, Joints path, int framesAgo) {
    target.copyTo(q);
    toTcp();
    for (int i = offsets.size() - 1; i >= 0; i--) {
      if (offsets.get(i).active()) {
        offsets.get(i).rebase(tcp, framesAgo);
      }
    }
    return solveNear(path) ? Optional.of(Joints.of(q)) : Optional.empty();
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

  /** The carried arm comes to rest and stays, whatever its offsets do. */
  void hold(double decelerationRadPerS2) {
    if (engaged && !hold.holding()) {
      hold.begin(decelerationRadPerS2);
      offsets.forEach(PathOffset::rest);
    }
  }

  /** Goes on after {@link #hold}. */
  void release() {
    hold.end();
  }

  /** Nothing is carried any more. */
  void end() {
    engaged = false;
    hold.clear();
    offsets.forEach(PathOffset::end);
  }
}
