package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.OptionalInt;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.kinematics.InverseKinematics;
import org.pendant.models.kinematics.InverseResult;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Stops, limits and power (manual 15.40, 15.41, 15.47, 16.37, 16.38, 16.40, 16.42, 16.43). */
final class SafetyBuiltins {
  private static final String MODULE = "internals";
  private static final String MOTION = "motion";

  private SafetyBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareStops(builtins);
    declareErrors(builtins);
    builtins
        .declare("high_holding_torque_disable")
        .manual(MODULE, "16.37")
        .doc("Lets a resting arm stop as easily as a moving one when something pushes it.")
        .does(call -> setHighHoldingTorque(call, false));
    builtins
        .declare("high_holding_torque_enable")
        .manual(MODULE, "16.38")
        .doc("Lets a resting arm hold against much, as it does at first.")
        .does(call -> setHighHoldingTorque(call, true));
    builtins
        .declare("is_within_safety_limits")
        .manual(MODULE, "16.40")
        .doc(
            "Whether joint limits, safety planes and tool direction allow a position; a pose must"
                + " be in reach, too.")
        .needs("position", Type.POSE_OR_JOINTS)
        .mayTake("qNear", Type.JOINTS, Unit.RADIAN, "current joint configuration")
        .returns(Type.BOOL)
        .effect(Effect.ASKS)
        .does(call -> call.answer(withinLimits(call)));
  }

  private static void declareStops(Builtins<ControlBox> builtins) {
    builtins
        .declare("powerdown")
        .manual(MODULE, "16.42")
        .doc("Ends the program and switches arm and controller off.")
        .does(SafetyBuiltins::powerdown);
    builtins
        .declare("protective_stop")
        .manual(MODULE, "16.43")
        .doc(
            "Stops the arm on its path as a protective stop does, and pauses the program, or ends"
                + " it where nothing is left to do.")
        .does(SafetyBuiltins::protectiveStop);
    builtins
        .declare("set_safety_mode_transition_hardness")
        .manual(MOTION, "15.47")
        .doc(
            "How the arm slows down for a safeguard stop and for reduced limits: 0 hard, as at"
                + " first, 1 soft.")
        .needs("type", Type.INT)
        .does(SafetyBuiltins::setHardness);
  }

  private static void declareErrors(Builtins<ControlBox> builtins) {
    builtins
        .declare("pause_on_error_code")
        .manual(MOTION, "15.40")
        .doc(
            "Pauses the program when an error with this code, and this argument if one is given,"
                + " comes up. Forgotten when the program ends.")
        .needs("code", Type.INT)
        .mayTake("argument", Type.INT, Unit.NONE, "any")
        .does(SafetyBuiltins::pauseOnErrorCode);
    builtins
        .declare("position_deviation_warning")
        .manual(MOTION, "15.41")
        .doc(
            "Whether the log gets a warning when a joint is away from its target; threshold is the"
                + " share, 0 to 1, of the deviation that would stop the arm.")
        .needs("enabled", Type.BOOL)
        .takes("threshold", Unit.NONE, 0.8)
        .does(SafetyBuiltins::deviationWarning);
  }

  private static Outcome setHighHoldingTorque(Call<ControlBox> call, boolean enabled) {
    call.host().safety().setHighHoldingTorque(enabled);
    return call.answer();
  }

  private static boolean withinLimits(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    Pose tcpInFlange = box.flange().tool().inFlange();
    if (call.kind(0) != ValueKind.POSE) {
      return box.safety().within(MotionArguments.joints(call, 0), tcpInFlange);
    }
    Pose flange = InverseKinematics.flangeOf(MotionArguments.pose(call, 0), tcpInFlange);
    double error = InverseKinematics.DEFAULT_ERROR;
    return switch (box.kinematics()
        .inverse()
        .find(flange, MotionArguments.near(call, 1), error, error)) {
      case InverseResult.Reached found -> box.safety().within(found.q(), tcpInFlange);
      case InverseResult.Unreachable none -> false;
    };
  }

  private static Outcome powerdown(Call<ControlBox> call) {
    call.host().safety().shutDown();
    call.program().halt();
    return call.answer();
  }

  private static Outcome protectiveStop(Call<ControlBox> call) {
    call.host().safety().protectiveStop();
    // the stop takes effect later in this frame: until then the program must not continue
    call.program().pause();
    return call.answer();
  }

  private static Outcome setHardness(Call<ControlBox> call) throws ScriptError {
    call.host().safety().setTransitionHardness(call.integer(0, 0, 1));
    return call.answer();
  }

  private static Outcome pauseOnErrorCode(Call<ControlBox> call) throws ScriptError {
    int code = call.integer(0);
    OptionalInt argument = call.given(1) ? OptionalInt.of(call.integer(1)) : OptionalInt.empty();
    call.host().safety().pauseOnErrorCode(code, argument);
    return call.answer();
  }

  private static Outcome deviationWarning(Call<ControlBox> call) throws ScriptError {
    boolean enabled = call.bool(0);
    double threshold = call.number(1);
    if (!(threshold >= 0 && threshold <= 1)) {
      throw call.refuse(1, text("zeroToOne"));
    }
    call.host().safety().positionDeviationWarning(enabled, threshold);
    return call.answer();
  }
}
