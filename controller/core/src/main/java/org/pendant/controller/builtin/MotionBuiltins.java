package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.InverseResult;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionPath;
import org.pendant.motion.Move;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PathLimits;
import org.pendant.motion.PlanningException;
import org.pendant.motion.Routes;
import org.pendant.motion.StopJ;
import org.pendant.motion.StopL;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Moves and stops (manual 15). */
final class MotionBuiltins {
  private static final String MODULE = "motion";

  private MotionBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareMoves(builtins);
    declareStops(builtins);
  }

  private static void declareMoves(Builtins<ControlBox> builtins) {
    builtins
        .declare("movej")
        .manual(MODULE, "15.29")
        .doc(
            "Moves all joints in proportion to a goal and waits until they rest there. a and v"
                + " limit the joint that turns farthest; t, if above 0, sets the duration instead.")
        .needs("q", Type.POSE_OR_JOINTS)
        .takes("a", Unit.RADIAN_PER_SECOND_SQUARED, 1.4)
        .takes("v", Unit.RADIAN_PER_SECOND, 1.05)
        .takes("t", Unit.SECOND, 0)
        .takes("r", Unit.METRE, 0)
        .physicalTime()
        .effect(Effect.MOVES)
        .does(MotionBuiltins::movej);
    builtins
        .declare("movel")
        .manual(MODULE, "15.30")
        .doc(
            "Moves the TCP along a straight line to a goal and waits until it rests there. a and v"
                + " limit the tool; t, if above 0, sets the duration instead.")
        .needs("pose", Type.POSE_OR_JOINTS)
        .takes("a", Unit.METRE_PER_SECOND_SQUARED, 1.2)
        .takes("v", Unit.METRE_PER_SECOND, 0.25)
        .takes("t", Unit.SECOND, 0)
        .takes("r", Unit.METRE, 0)
        .physicalTime()
        .effect(Effect.MOVES)
        .does(MotionBuiltins::movel);
    builtins
        .declare("set_pos")
        .manual(MODULE, "15.46")
        .doc("Puts the simulated arm at joint positions at once, without moving there.")
        .needs("q", Type.JOINTS)
        .does(MotionBuiltins::setPos);
    builtins
        .declare("reset_revolution_counter")
        .manual(MODULE, "15.42")
        .doc(
            "Counts the turns of a joint without end anew, so that its position is the one nearest"
                + " to qNear; the arm must be at rest. Other joints stay as they are.")
        .takes("qNear", Type.JOINTS, NumberList.of(Joints.ZERO.toArray()))
        .does(MotionBuiltins::resetRevolutions);
  }

  private static void declareStops(Builtins<ControlBox> builtins) {
    builtins
        .declare("stopj")
        .manual(MODULE, "15.51")
        .doc("Slows all joints down in proportion and waits until they rest.")
        .needs("a", Unit.RADIAN_PER_SECOND_SQUARED)
        .physicalTime()
        .does(MotionBuiltins::stopj);
    builtins
        .declare("stopl")
        .manual(MODULE, "15.52")
        .doc("Slows the tool down along its present direction and waits until it rests.")
        .needs("a", Unit.METRE_PER_SECOND_SQUARED)
        .mayTake("aRot", Type.NUMBER, Unit.RADIAN_PER_SECOND_SQUARED, "a")
        .physicalTime()
        .does(MotionBuiltins::stopl);
  }

  private static Outcome movej(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    PathLimits pathLimits = pathLimits(call);
    Pose tcp = box.flange().tool().inFlange();
    if (call.kind(0) == ValueKind.POSE) {
      Pose goal = MotionArguments.pose(call, 0);
      return move(
          call,
          "movej",
          from -> toJoints(box, from, reach(box, goal, tcp, from), goal, pathLimits));
    }
    Joints goal = MotionArguments.jointsInRange(call, 0, "q");
    Pose waypoint = box.kinematics().forward().tcpPose(goal, tcp);
    return move(call, "movej", from -> toJoints(box, from, goal, waypoint, pathLimits));
  }

  static MotionPath toJoints(
      ControlBox box, Joints from, Joints goal, Pose waypoint, PathLimits pathLimits) {
    Pose tcp = box.flange().tool().inFlange();
    return Routes.joints(box.arm().description(), from, goal, waypoint, tcp, pathLimits);
  }

  /** Motion version 2 plans within what the arm can do, version 1 as it is told (manual 14). */
  private static PathLimits pathLimits(Call<ControlBox> call) throws ScriptError {
    MoveLimits limits = MotionArguments.moveLimits(call, 1);
    ControlBox box = call.host();
    double asked = limits.timed() ? Double.POSITIVE_INFINITY : limits.speed();
    return box.planning().settings().version() == 2
        ? box.planning().limits().share(1, 1, asked)
        : box.planning().limits().asAsked(limits);
  }

  private static Outcome movel(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    PathLimits pathLimits = pathLimits(call);
    Pose tcp = box.flange().tool().inFlange();
    Pose goal =
        call.kind(0) == ValueKind.POSE
            ? MotionArguments.pose(call, 0)
            : box.kinematics().forward().tcpPose(MotionArguments.jointGoal(call, 0), tcp);
    return move(call, "movel", from -> toPose(box, from, goal, tcp, pathLimits));
  }

  /** A straight line of the TCP, which may lead out of reach: the arm stops where it does. */
  static MotionPath toPose(
      ControlBox box, Joints from, Pose goal, Pose tcpInFlange, PathLimits pathLimits) {
    Pose start = box.kinematics().forward().tcpPose(from, tcpInFlange);
    return Routes.line(box.arm().description(), from, start, goal, tcpInFlange, pathLimits);
  }

  /** Arguments a, v, t and r of movej and movel, from the second on. */
  private static Outcome move(Call<ControlBox> call, String function, Move.PathPlanner route)
      throws ScriptError {
    MoveLimits limits = MotionArguments.moveLimits(call, 1);
    double radiusM = MotionArguments.notNegative(call, 4);
    double jerkRampS = call.host().planning().settings().jerkRampS();
    return MotionWait.move(call, function, new Move(route, limits, radiusM, jerkRampS));
  }

  /** Joint positions near {@code from} that put the TCP at the goal. */
  static Joints reach(ControlBox box, Pose goal, Pose tcp, Joints from) throws PlanningException {
    Pose flange = InverseKinematics.flangeOf(goal, tcp);
    double error = InverseKinematics.DEFAULT_ERROR;
    return switch (box.kinematics().inverse().find(flange, from, error, error)) {
      case InverseResult.Reached found -> found.q();
      case InverseResult.Unreachable none ->
          throw new PlanningException(
              "no-solution",
              text("goalOutOfReach", KinematicsBuiltins.text(goal), none.cause().text()));
    };
  }

  private static Outcome setPos(Call<ControlBox> call) throws ScriptError {
    Joints goal = MotionArguments.jointsInRange(call, 0, "q");
    refuseWhileMoving(call);
    Planning.act(call, () -> call.host().drive().jumpTo(goal));
    return call.answer();
  }

  private static Outcome resetRevolutions(Call<ControlBox> call) throws ScriptError {
    double[] near = MotionArguments.jointGoal(call, 0).toArray();
    ControlBox box = call.host();
    Joints target = box.motion().positionRad();
    Joints reset = target;
    List<JointLimits> limits = box.arm().description().joints();
    for (int i = 0; i < Joints.COUNT; i++) {
      long turns = Math.round((target.get(i) - near[i]) / (2 * Math.PI));
      if (limits.get(i).unlimited() && turns != 0) {
        reset = reset.with(i, target.get(i) - 2 * Math.PI * turns);
      }
    }
    if (reset.equals(target)) {
      return call.answer();
    }
    refuseWhileMoving(call);
    Joints goal = reset;
    Planning.act(call, () -> box.drive().jumpTo(goal));
    return call.answer();
  }

  private static void refuseWhileMoving(Call<ControlBox> call) throws ScriptError {
    if (call.host().motion().moving()) {
      throw call.failure("robot-in-use", text("armMoves"));
    }
  }

  private static Outcome stopj(Call<ControlBox> call) throws ScriptError {
    double deceleration = MotionArguments.positive(call, 0);
    return MotionWait.stop(call, "stopj", (from, speed) -> new StopJ(from, speed, deceleration));
  }

  private static Outcome stopl(Call<ControlBox> call) throws ScriptError {
    double deceleration = MotionArguments.positive(call, 0);
    double turning = call.given(1) ? MotionArguments.positive(call, 1) : deceleration;
    ArmDescription arm = call.host().arm().description();
    Pose tcp = call.host().flange().tool().inFlange();
    return MotionWait.stop(
        call, "stopl", (from, speed) -> new StopL(arm, from, speed, tcp, deceleration, turning));
  }
}
