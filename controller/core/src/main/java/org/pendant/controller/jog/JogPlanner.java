package org.pendant.controller.jog;

import static org.pendant.controller.jog.JogTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.InverseResult;
import org.pendant.models.pose.Pose;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionPlan;
import org.pendant.motion.MoveJ;
import org.pendant.motion.MoveL;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PlanningException;
import org.pendant.motion.ToolJog;

/**
 * Jog planner: makes motions of what an operator wants by hand; refuses goals that the arm must not
 * go to.
 */
final class JogPlanner {
  /** How far before the end of its range a joint stops, rad. */
  static final double RANGE_MARGIN_RAD = 0.01;

  private static final double JOINT_ACCELERATION_RAD_PER_S2 = 1.4;
  private static final double TOOL_ACCELERATION_M_PER_S2 = 0.5;

  /** Farther than an operator holds a button for a joint that turns without end, rad. */
  private static final double ENDLESS_RAD = 1000;

  private final ControlBox box;

  JogPlanner(ControlBox box) {
    this.box = box;
  }

  /**
   * The motion for a move, once it is known where it begins.
   *
   * @param speedFraction above 0, at most 1
   * @throws PlanningException when the goal is not allowed
   */
  MotionPlan plan(JogMove move, double speedFraction) throws PlanningException {
    MoveLimits joints =
        new MoveLimits(
            JOINT_ACCELERATION_RAD_PER_S2, speedFraction * Jogging.JOINT_SPEED_RAD_PER_S, 0);
    MoveLimits tool =
        new MoveLimits(TOOL_ACCELERATION_M_PER_S2, speedFraction * Jogging.TOOL_SPEED_M_PER_S, 0);
    Pose tcp = box.flange().tool().inFlange();
    return switch (move) {
      case JogMove.TurnJoint turn -> (from, speed) -> moveTo(from, rangeEnd(turn, from), joints);
      case JogMove.MoveTool along ->
          (from, speed) -> {
            Pose start = box.kinematics().forward().tcpPose(from, tcp);
            Pose twist = along.direction().twistInBase(along.frame(), start);
            return new ToolJog(box.arm().description(), from, start, twist, tcp, tool);
          };
      case JogMove.ToJoints to -> {
        requireAllowed(to.goalRad());
        yield (from, speed) -> moveTo(from, to.goalRad(), joints);
      }
      case JogMove.ToPose to ->
          (from, speed) -> moveTo(from, reach(to.tcpInBase(), tcp, from), joints);
      case JogMove.StraightTo to ->
          (from, speed) -> {
            reach(to.tcpInBase(), tcp, from);
            Pose start = box.kinematics().forward().tcpPose(from, tcp);
            return new MoveL(box.arm().description(), from, start, to.tcpInBase(), tcp, tool);
          };
    };
  }

  private Motion moveTo(Joints from, Joints goal, MoveLimits limits) {
    Pose waypoint = box.kinematics().forward().tcpPose(goal, box.flange().tool().inFlange());
    return new MoveJ(box.arm().description(), from, goal, waypoint, limits);
  }

  /** Where a joint stops; never behind where it is. */
  private Joints rangeEnd(JogMove.TurnJoint turn, Joints from) {
    int i = turn.joint();
    double here = from.get(i);
    double end =
        turn.direction() > 0
            ? Math.max(here, Math.min(here + ENDLESS_RAD, maxRad(i) - RANGE_MARGIN_RAD))
            : Math.min(here, Math.max(here - ENDLESS_RAD, minRad(i) + RANGE_MARGIN_RAD));
    return from.with(i, end);
  }

  /** The smallest position of joint i that arm and safety limits allow now, rad. */
  double minRad(int i) {
    JointLimits arm = box.arm().description().joints().get(i);
    return Math.max(arm.lowestRad(), box.safety().limits().jointMinRad().get(i));
  }

  /** The largest position of joint i that arm and safety limits allow now, rad. */
  double maxRad(int i) {
    JointLimits arm = box.arm().description().joints().get(i);
    return Math.min(arm.highestRad(), box.safety().limits().jointMaxRad().get(i));
  }

  private Joints reach(Pose goal, Pose tcp, Joints from) throws PlanningException {
    requireFinite(goal);
    double error = InverseKinematics.DEFAULT_ERROR;
    Pose flange = InverseKinematics.flangeOf(goal, tcp);
    return switch (box.kinematics().inverse().find(flange, from, error, error)) {
      case InverseResult.Reached found -> {
        requireAllowed(found.q());
        yield found.q();
      }
      case InverseResult.Unreachable none ->
          throw new PlanningException("no-solution", text("goalOutOfReach", none.cause().text()));
    };
  }

  private static void requireFinite(Pose goal) throws PlanningException {
    for (int i = 0; i < Pose.SIZE; i++) {
      if (!Double.isFinite(goal.get(i))) {
        throw new PlanningException("no-solution", text("goalNotFinite", goal));
      }
    }
  }

  private void requireAllowed(Joints goal) throws PlanningException {
    for (int i = 0; i < Joints.COUNT; i++) {
      double q = goal.get(i);
      if (!(q >= minRad(i) && q <= maxRad(i)) || Double.isInfinite(q)) {
        throw new PlanningException("joint-limit", text("jointRange", i, q, minRad(i), maxRad(i)));
      }
    }
    if (!box.safety().within(goal, box.flange().tool().inFlange())) {
      throw new PlanningException("safety-limit", text("goalBeyondSafety"));
    }
  }
}
