package org.pendant.desktop.move;

import java.util.Optional;
import org.pendant.controller.jog.JogDirection;
import org.pendant.controller.jog.JogMove;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Step jog: moves by steps: each press moves the goal on, so that ten steps lead as far as one that
 * is ten times as long, however fast they follow each other. One thread uses it.
 */
final class StepJog {
  /** The arm is at its goal when nothing is farther from it than this, m or rad. */
  private static final double NEAR = 1e-6;

  private final JogHold hold;
  private Optional<JogMove> goal = Optional.empty();

  /** No step is under way; {@code hold} carries them out. */
  StepJog(JogHold hold) {
    this.hold = hold;
  }

  /**
   * Moves the tool on.
   *
   * @param axesInBase a frame along whose axes; only its rotation counts
   * @param tcpInBase where the TCP should be now
   */
  void move(
      JogDirection direction, JogStep step, Pose axesInBase, Pose tcpInBase, double speedFraction) {
    Pose from =
        goal.isPresent() && goal.get() instanceof JogMove.StraightTo straight
            ? straight.tcpInBase()
            : tcpInBase;
    go(new JogMove.StraightTo(Poses.add(way(direction, step, axesInBase), from)), speedFraction);
  }

  /** What the TCP does, along the axes of the base. */
  private static Pose way(JogDirection direction, JogStep step, Pose axesInBase) {
    Pose turn = new Pose(0, 0, 0, axesInBase.rx(), axesInBase.ry(), axesInBase.rz());
    boolean along = direction.kind() == JogDirection.Kind.ALONG;
    double by = along ? step.lengthM() : step.angleRad();
    Pose way =
        Poses.trans(
            turn, new Pose(by * direction.x(), by * direction.y(), by * direction.z(), 0, 0, 0));
    return along
        ? new Pose(way.x(), way.y(), way.z(), 0, 0, 0)
        : new Pose(0, 0, 0, way.x(), way.y(), way.z());
  }

  /**
   * Where a joint would be after a step, rad.
   *
   * @param direction 1 or -1
   * @param positionRad where the joints should be now
   */
  double after(int joint, int direction, JogStep step, Joints positionRad) {
    return jointsFrom(positionRad).get(joint) + direction * step.angleRad();
  }

  /** Turns a joint on. */
  void turn(int joint, int direction, JogStep step, Joints positionRad, double speedFraction) {
    double after = after(joint, direction, step, positionRad);
    go(new JogMove.ToJoints(jointsFrom(positionRad).with(joint, after)), speedFraction);
  }

  private Joints jointsFrom(Joints positionRad) {
    return goal.isPresent() && goal.get() instanceof JogMove.ToJoints to
        ? to.goalRad()
        : positionRad;
  }

  private void go(JogMove next, double speedFraction) {
    goal = Optional.of(next);
    hold.press(next, speedFraction);
  }

  /**
   * Takes the newest snapshot: the arm that has come to its goal, or goes no further, is let go. A
   * screen that hung for a moment has stopped it on the way, and moves it on.
   */
  void take(ControllerState newest) {
    boolean rests = hold.settled() && !newest.arm().moving();
    if (goal.isPresent() && rests && (hold.refused() || reached(goal.get(), newest.arm()))) {
      stop();
    }
  }

  private static boolean reached(JogMove goal, ArmState arm) {
    return switch (goal) {
      case JogMove.StraightTo straight ->
          Poses.distance(straight.tcpInBase(), arm.targetTcpInBase()) < NEAR;
      case JogMove.ToJoints to -> to.goalRad().maxAbsDifference(arm.targetPositionRad()) < NEAR;
      case JogMove.ToPose _, JogMove.TurnJoint _, JogMove.MoveTool _ -> true;
    };
  }

  /** Whether a step is under way. */
  boolean underWay() {
    return goal.isPresent();
  }

  /** Comes to rest on the way. */
  void stop() {
    goal = Optional.empty();
    hold.release();
  }
}
