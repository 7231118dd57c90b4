package org.pendant.desktop.move;

import java.util.Collections;
import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Goal presenter: joint positions and pose of the arm, or of the goal that the user types in
 * either: the other shows what comes of it. One thread uses it.
 */
final class GoalPresenter {
  private static final Reach NOTHING_TYPED = new Reach(Optional.empty(), "");

  private final GhostArm ghost;
  private final Draft joints;
  private final Draft pose;
  private PoseForm form;
  private ArmDescription arm;
  private InverseKinematics inverse;
  private ForwardKinematics forward;
  private Pose frameInBase = Pose.ZERO;
  private Reach reach = NOTHING_TYPED;
  private Optional<Joints> ghostRad = Optional.empty();

  /**
   * Nothing is typed.
   *
   * @param ghost shows goals
   * @param check whether a joint may be somewhere
   */
  GoalPresenter(ArmDescription arm, PoseForm form, GhostArm ghost, Draft.Check check) {
    this.ghost = ghost;
    this.form = form;
    joints = new Draft(Collections.nCopies(Joints.COUNT, form.angle()), check);
    pose = new Draft(form.units(), (index, value) -> Optional.empty());
    joints.whenTyped(pose::reset);
    pose.whenTyped(joints::reset);
    setArm(arm);
  }

  /** Another robot has been switched on. */
  void setArm(ArmDescription other) {
    arm = other;
    inverse = new InverseKinematics(other);
    forward = new ForwardKinematics(other);
    joints.reset();
    pose.reset();
  }

  /** Shows the arm, as far as nothing is typed. */
  void take(ControllerState newest) {
    Pose tcpInFlange = newest.arm().tool().inFlange();
    Joints near = newest.arm().targetPositionRad();
    reach =
        pose.edited() && pose.valid()
            ? Reach.of(arm, inverse, goalInBase(), tcpInFlange, near)
            : NOTHING_TYPED;
    Joints shown = reach.q().orElse(newest.arm().actualPositionRad());
    joints.follow(shown.toArray());
    Pose tcp =
        typedJoints()
            .map(q -> forward.tcpPose(q, tcpInFlange))
            .orElseGet(() -> newest.arm().actualTcpInBase());
    pose.follow(form.numbers(inFrame(tcp)));
    showGhost(reach.q().or(this::typedJoints));
  }

  /** What was typed is forgotten. */
  void discard() {
    joints.reset();
    pose.reset();
    hide();
  }

  /** The goal is not shown until the next snapshot is taken. */
  void hide() {
    showGhost(Optional.empty());
  }

  private void showGhost(Optional<Joints> wanted) {
    if (!wanted.equals(ghostRad)) {
      ghostRad = wanted;
      ghost.show(wanted);
    }
  }

  /** The frame in which poses are shown and typed from now on, by its pose in the base. */
  void setFrame(Pose inBase) {
    if (!inBase.equals(frameInBase)) {
      Pose goal = goalInBase();
      frameInBase = inBase;
      pose.convert(form.units(), form.numbers(inFrame(goal)));
    }
  }

  private Pose inFrame(Pose inBase) {
    return frameInBase.equals(Pose.ZERO) ? inBase : Poses.trans(Poses.inverse(frameInBase), inBase);
  }

  /** Shows all numbers in another form. */
  void setForm(PoseForm other) {
    Pose shown = form.pose(pose.values());
    pose.convert(other.units(), other.numbers(shown));
    boolean angle = form.angle() != other.angle();
    form = other;
    if (angle) {
      joints.convert(Collections.nCopies(Joints.COUNT, other.angle()), joints.values());
    }
  }

  /** Joint positions, of the arm or of the goal. */
  Draft joints() {
    return joints;
  }

  /** The pose of the TCP in the frame, of the arm or of the goal. */
  Draft pose() {
    return pose;
  }

  /** The joint positions that the user has typed, if they may be gone to. */
  Optional<Joints> typedJoints() {
    return joints.edited() && joints.valid()
        ? Optional.of(Joints.of(joints.values()))
        : Optional.empty();
  }

  /** The pose that the user has typed, in the base, if the arm reaches it. */
  Optional<Pose> typedPoseInBase() {
    return poseReachable() ? Optional.of(goalInBase()) : Optional.empty();
  }

  private Pose goalInBase() {
    Pose typed = form.pose(pose.values());
    return frameInBase.equals(Pose.ZERO) ? typed : Poses.trans(frameInBase, typed);
  }

  /** Whether the pose that was typed can be gone to. */
  boolean poseReachable() {
    return reach.q().isPresent();
  }

  /** What is to be said of the pose that was typed; empty if nothing. */
  String poseText() {
    return pose.problem().isEmpty() ? reach.text() : "";
  }
}
