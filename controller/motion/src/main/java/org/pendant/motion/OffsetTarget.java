package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Offset target: where the joints are to be when offsets displace the TCP from its path. Speeds and
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
  private final JointNumbers before = new JointNumbers();
  private final JointNumbers position = new JointNumbers();
  private final JointNumbers speed = new JointNumbers();
  private final JointNumbers acceleration = new JointNumbers();

  /** What they are to be, until it is known that the joints can do it. */
  private final JointNumbers next = new JointNumbers();

  private final JointNumbers nextSpeed = new JointNumbers();

  OffsetTarget(ArmDescription arm, JointSpeedCheck jointSpeeds) {
    this.jointSpeeds = jointSpeeds;
    forward = new ForwardKinematics(arm);
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

  JointNumbers position() {
    return position;
  }

  JointNumbers speed() {
    return speed;
  }

  JointNumbers acceleration() {
    return acceleration;
  }

  /**
   * The next target.
   *
   * @param path where the path is, and how fast it goes there, which is taken over when offsets
   *     begin
   * @return why there is none; the target is what it was then
   */
  Optional<MotionFailure> step(PathState path) {
    if (!anyActive()) {
      engaged = false;
      hold.clear();
      return Optional.empty();
    }
    if (!engaged) {
      engaged = true;
      position.set(path.position());
      speed.set(path.speed());
    }
    if (hold.holding()) {
      hold.step(position, speed, q);
      propose(q);
      accept();
      return Optional.empty();
    }
    System.arraycopy(path.position().numbers(), 0, q, 0, N);
    toTcp();
    for (int i = 0; i < offsets.size(); i++) {
      if (offsets.get(i).active()) {
        offsets.get(i).apply(tcp);
      }
    }
    if (!solveNear(position.numbers())) {
      return Optional.of(new MotionFailure(MotionFailure.OUT_OF_REACH, text("offsetOutOfReach")));
    }
    hold.leadBack(position.numbers(), q);
    propose(q);
    Optional<MotionFailure> failure = jointSpeeds.carried(nextSpeed);
    if (failure.isEmpty()) {
      accept();
    }
    return failure;
  }

  private void propose(double[] positions) {
    next.set(positions);
    nextSpeed.setRate(position, next);
  }

  private void accept() {
    acceleration.setRate(speed, nextSpeed);
    speed.set(nextSpeed);
    before.set(position);
    position.set(next);
  }

  private void toTcp() {
    forward.flange(q, flange);
    Transforms.multiply(flange, tcpInFlange, tcp);
  }

  private boolean solveNear(double[] near) {
    Transforms.multiply(tcp, flangeInTcp, flange);
    System.arraycopy(near, 0, q, 0, N);
    return inverse.track(flange, q);
  }

  /**
   * The path anew, so that those offsets that are still active carry it to where the target is.
   *
   * @param path where it has been, rad
   * @return positions, rad, and speeds, rad/s; empty if it would be out of reach
   */
  Optional<Rebased> rebased(JointNumbers path) {
    if (!anyActive()) {
      return Optional.of(new Rebased(position.joints(), speed.joints()));
    }
    if (!rebase(position, path, 0)) {
      return Optional.empty();
    }
    JointNumbers last = new JointNumbers();
    last.set(q);
    if (!rebase(before, path, 1)) {
      return Optional.empty();
    }
    JointNumbers earlier = new JointNumbers();
    earlier.set(q);
    JointNumbers rate = new JointNumbers();
    rate.setRate(earlier, last);
    return Optional.of(new Rebased(last.joints(), rate.joints()));
  }

  /** A path that the target stays where it is with. */
  record Rebased(Joints positionRad, Joints speedRadPerS) {}

  /** Finds the joints that what is still active carries to a target; false if there are none. */
  private boolean rebase(JointNumbers target, JointNumbers path, int framesAgo) {
    System.arraycopy(target.numbers(), 0, q, 0, N);
    toTcp();
    for (int i = offsets.size() - 1; i >= 0; i--) {
      if (offsets.get(i).active()) {
        offsets.get(i).rebase(tcp, framesAgo);
      }
    }
    return solveNear(path.numbers());
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

  /** Continues after {@link #hold}. */
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
