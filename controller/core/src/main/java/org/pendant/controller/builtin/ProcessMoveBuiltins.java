package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.ArcRoute;
import org.pendant.motion.Move;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PathLimits;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Moves at an even speed of the tool (manual 15.28, 15.31). */
final class ProcessMoveBuiltins {
  private static final String MODULE = "motion";

  private ProcessMoveBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("movec")
        .manual(MODULE, "15.28")
        .doc(
            "Moves the TCP along a circle through one point to another and waits until it rests"
                + " there. With mode 0 the tool turns evenly to the orientation of the goal, with"
                + " mode 1 it keeps its orientation to the circle.")
        .needs("pose_via", Type.POSE_OR_JOINTS)
        .needs("pose_to", Type.POSE_OR_JOINTS)
        .takes("a", Unit.METRE_PER_SECOND_SQUARED, 1.2)
        .takes("v", Unit.METRE_PER_SECOND, 0.25)
        .takes("r", Unit.METRE, 0)
        .takes("mode", Unit.NONE, 0)
        .physicalTime()
        .effect(Effect.MOVES)
        .does(ProcessMoveBuiltins::movec);
    builtins
        .declare("movep")
        .manual(MODULE, "15.31")
        .doc(
            "Moves the TCP along a straight line at an even speed. With a blend radius the corner"
                + " to a following movep or movec is rounded on a circle without slowing down.")
        .needs("pose", Type.POSE_OR_JOINTS)
        .takes("a", Unit.METRE_PER_SECOND_SQUARED, 1.2)
        .takes("v", Unit.METRE_PER_SECOND, 0.25)
        .takes("r", Unit.METRE, 0)
        .physicalTime()
        .effect(Effect.MOVES)
        .does(ProcessMoveBuiltins::movep);
  }

  private static Outcome movep(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    Pose tcp = box.flange().tool().inFlange();
    Pose goal = pose(call, 0);
    MoveLimits limits = limits(call, 1);
    PathLimits pathLimits = box.planning().limits().asAsked(limits);
    return move(
        call, "movep", limits, 3, from -> MotionBuiltins.toPose(box, from, goal, tcp, pathLimits));
  }

  private static Outcome movec(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    Pose tcp = box.flange().tool().inFlange();
    Pose via = pose(call, 0);
    Pose goal = pose(call, 1);
    MoveLimits limits = limits(call, 2);
    boolean fixed = call.integer(5, 0, 1) == 1;
    PathLimits pathLimits = box.planning().limits().asAsked(limits);
    ArcRoute route = new ArcRoute(box.arm().description(), via, goal, fixed, tcp, pathLimits);
    return move(
        call,
        "movec",
        limits,
        4,
        from -> route.from(from, box.kinematics().forward().tcpPose(from, tcp)));
  }

  private static MoveLimits limits(Call<ControlBox> call, int index) throws ScriptError {
    double acceleration = MotionArguments.positive(call, index);
    return new MoveLimits(acceleration, MotionArguments.positive(call, index + 1), 0);
  }

  /** A pose of the TCP, or the one that joint positions give. */
  private static Pose pose(Call<ControlBox> call, int index) throws ScriptError {
    if (call.kind(index) == ValueKind.POSE) {
      return MotionArguments.pose(call, index);
    }
    ControlBox box = call.host();
    return box.kinematics()
        .forward()
        .tcpPose(MotionArguments.jointGoal(call, index), box.flange().tool().inFlange());
  }

  private static Outcome move(
      Call<ControlBox> call, String function, MoveLimits limits, int radius, Move.PathPlanner route)
      throws ScriptError {
    double radiusM = MotionArguments.notNegative(call, radius);
    return MotionWait.move(call, function, new Move(route, limits, radiusM, 0, Move.Kind.PROCESS));
  }
}
