package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.motion.Move;
import org.pendant.motion.MoveLimits;
import org.pendant.motion.PathLimits;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/**
 * Optimove builtins: moves as fast as a share of what the arm is capable of on their path (manual
 * 15.32, 15.33).
 */
final class OptimoveBuiltins {
  private static final String MODULE = "motion";

  /** More than any arm can do: what it can do decides. */
  private static final MoveLimits FREE = new MoveLimits(1e9, 1e9, 0);

  private OptimoveBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("optimovej")
        .manual(MODULE, "15.32")
        .doc(
            "Moves all joints in proportion to a goal, with limited jerk. a and v are shares, up to"
                + " 1, of what the joints can do on the way. The goal is joint positions, a pose, a"
                + " struct of a pose and the name of its frame, or the name of an object.")
        .needs("goal", Type.ANY)
        .takes("a", Unit.NONE, 0.3)
        .takes("v", Unit.NONE, 0.3)
        .takes("r", Unit.METRE, 0)
        .physicalTime()
        .effect(Effect.MOVES)
        .does(OptimoveBuiltins::optimovej);
    builtins
        .declare("optimovel")
        .manual(MODULE, "15.33")
        .doc(
            "Moves the TCP along a straight line to a goal, with limited jerk. a and v are shares,"
                + " up to 1, of what the arm can do on the way. The goal is joint positions, a"
                + " pose, a struct of a pose and the name of its frame, or the name of an object.")
        .needs("goal", Type.ANY)
        .takes("a", Unit.NONE, 0.3)
        .takes("v", Unit.NONE, 0.3)
        .takes("r", Unit.METRE, 0)
        .physicalTime()
        .effect(Effect.MOVES)
        .does(OptimoveBuiltins::optimovel);
  }

  private static Outcome optimovej(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    Pose tcp = box.flange().tool().inFlange();
    PathLimits pathLimits = pathLimits(call);
    if (call.kind(0) == ValueKind.LIST) {
      Joints goal = MotionArguments.jointsInRange(call, 0, "goal");
      Pose waypoint = box.kinematics().forward().tcpPose(goal, tcp);
      return move(
          call,
          "optimovej",
          from -> MotionBuiltins.toJoints(box, from, goal, waypoint, pathLimits));
    }
    MoveGoal goal = MoveGoal.of(call, 0);
    return move(
        call,
        "optimovej",
        from -> {
          Pose waypoint = goal.inBase(from);
          Joints to = MotionBuiltins.reach(box, waypoint, tcp, from);
          return MotionBuiltins.toJoints(box, from, to, waypoint, pathLimits);
        });
  }

  private static Outcome optimovel(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    Pose tcp = box.flange().tool().inFlange();
    PathLimits pathLimits = pathLimits(call);
    MoveGoal goal = MoveGoal.of(call, 0);
    return move(
        call,
        "optimovel",
        from -> MotionBuiltins.toPose(box, from, goal.inBase(from), tcp, pathLimits));
  }

  private static PathLimits pathLimits(Call<ControlBox> call) throws ScriptError {
    double acceleration = share(call, 1);
    double speed = share(call, 2);
    return call.host().planning().limits().share(speed, acceleration, Double.POSITIVE_INFINITY);
  }

  private static double share(Call<ControlBox> call, int index) throws ScriptError {
    double share = call.number(index);
    if (!(share > 0 && share <= 1)) {
      throw call.refuse(index, text("aboveZeroToOne"));
    }
    return share;
  }

  private static Outcome move(Call<ControlBox> call, String function, Move.PathPlanner route)
      throws ScriptError {
    double radiusM = MotionArguments.notNegative(call, 3);
    double jerkRampS = call.host().planning().settings().smoothRampS();
    return MotionWait.move(call, function, new Move(route, FREE, radiusM, jerkRampS));
  }
}
