package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.InverseResult;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;

/** Kinematics builtins: from joint positions to poses and back (manual 16.13 to 16.16). */
final class KinematicsBuiltins {
  private static final String MODULE = "internals";
  private static final int FORWARD_NS = 2000;
  private static final int INVERSE_NS = 25_000;
  private static final String PRESENT_JOINTS = "current joint positions";
  private static final String ACTIVE_TCP = "active tcp";

  private KinematicsBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_forward_kin")
        .manual(MODULE, "16.13")
        .doc("The pose of the TCP in the base frame for joint positions.")
        .mayTake("q", Type.JOINTS, Unit.RADIAN, PRESENT_JOINTS)
        .mayTake("tcp", Type.POSE, Unit.NONE, ACTIVE_TCP)
        .returns(Type.POSE)
        .effect(Effect.ASKS)
        .costs(FORWARD_NS)
        .does(KinematicsBuiltins::forward);
    withTolerances(
            builtins
                .declare("get_inverse_kin")
                .manual(MODULE, "16.15")
                .doc(
                    "The joint positions nearest to qnear that put the TCP at a pose. It is an"
                        + " error if there are none; get_inverse_kin_has_solution tells"
                        + " beforehand.")
                .needs("x", Type.POSE))
        .returns(Type.JOINTS)
        .effect(Effect.ASKS)
        .costs(INVERSE_NS)
        .does(KinematicsBuiltins::inverse);
    withTolerances(
            builtins
                .declare("get_inverse_kin_has_solution")
                .manual(MODULE, "16.16")
                .doc("Whether get_inverse_kin finds joint positions for a pose.")
                .needs("pose", Type.POSE))
        .returns(Type.BOOL)
        .effect(Effect.ASKS)
        .costs(INVERSE_NS)
        .does(call -> call.answer(solve(call) instanceof InverseResult.Reached));
  }

  private static Declaration<ControlBox> withTolerances(Declaration<ControlBox> declaration) {
    double error = InverseKinematics.DEFAULT_ERROR;
    return declaration
        .mayTake("qnear", Type.JOINTS, Unit.RADIAN, PRESENT_JOINTS)
        .takes("maxPositionError", Unit.METRE, error)
        .takes("maxOrientationError", Unit.RADIAN, error)
        .mayTake("tcp", Type.POSE, Unit.NONE, ACTIVE_TCP);
  }

  private static Outcome forward(Call<ControlBox> call) throws ScriptError {
    Joints q =
        call.given(0)
            ? MotionArguments.joints(call, 0)
            : call.host().arm().simulated().positionRad();
    return call.answer(
        call.host().kinematics().forward().tcpPose(q, MotionArguments.tcpOffset(call, 1)));
  }

  private static Outcome inverse(Call<ControlBox> call) throws ScriptError {
    return switch (solve(call)) {
      case InverseResult.Reached found -> call.answer(found.q());
      case InverseResult.Unreachable none ->
          throw call.failure(
              "no-solution",
              BuiltinTexts.text("poseOutOfReach", text(call.pose(0)), none.cause().text()));
    };
  }

  private static InverseResult solve(Call<ControlBox> call) throws ScriptError {
    Pose pose = MotionArguments.pose(call, 0);
    Pose flange = InverseKinematics.flangeOf(pose, MotionArguments.tcpOffset(call, 4));
    return call.host()
        .kinematics()
        .inverse()
        .find(
            flange,
            MotionArguments.near(call, 1),
            MotionArguments.notNegative(call, 2),
            MotionArguments.notNegative(call, 3));
  }

  /** A pose as scripts print it. */
  static String text(Pose pose) {
    return new PoseValue(pose).text();
  }
}
