package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.PlanningException;
import org.pendant.motion.servo.FrictionShare;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Speeds, positions and torques that programs stream (manual 15.2, 15.44, 15.48, 15.49). */
final class ServoBuiltins {
  private static final String MODULE = "motion";

  /** Faster than any joint turns or tool moves, rad/s and m/s: more is a mistake in the units. */
  private static final double MAX_SPEED = 20;

  private static final double MIN_LOOKAHEAD_S = 0.03;
  private static final double MAX_LOOKAHEAD_S = 0.2;
  private static final double MIN_GAIN = 100;
  private static final double MAX_GAIN = 2000;

  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);

  private ServoBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareSpeeds(builtins);
    declareServos(builtins);
    builtins
        .declare("direct_torque")
        .manual(MODULE, "15.2")
        .doc(
            "Drives the joints by torques, in Nm, for one frame, whatever the speed slider says."
                + " Weight is compensated, most of the friction too unless told otherwise, or the"
                + " shares of it that are given for each joint; Coriolis forces are not. Without"
                + " another call the arm comes to rest from where it is.")
        .needs("torques", Type.JOINTS)
        .takes("friction_comp", Type.BOOL, Value.of(true))
        .mayTake("viscous_scale", Type.JOINTS, Unit.NONE, "0.8, or 0 without friction_comp")
        .mayTake("coulomb_scale", Type.JOINTS, Unit.NONE, "0.8, or 0 without friction_comp")
        .physicalTime()
        .does(ServoBuiltins::directTorque);
  }

  private static void declareSpeeds(Builtins<ControlBox> builtins) {
    builtins
        .declare("speedj")
        .manual(MODULE, "15.48")
        .doc(
            "Brings the joints to constant speeds, all at the same moment. Waits for time t, or"
                + " without it until the speeds are reached. The arm keeps moving as long as no"
                + " time passes in the program; then it slows down by a, unless something takes it"
                + " over.")
        .needs("qd", Type.JOINTS)
        .needs("a", Unit.RADIAN_PER_SECOND_SQUARED)
        .mayTake("t", Type.NUMBER, Unit.SECOND, "until target speed is reached")
        .alias("t_min")
        .physicalTime()
        .does(ServoBuiltins::speedj);
    builtins
        .declare("speedl")
        .manual(MODULE, "15.49")
        .doc(
            "Brings the TCP to a constant velocity and angular velocity along the axes of the"
                + " base. Waits and ends as speedj does.")
        .needs("xd", Type.LIST)
        .needs("a", Unit.METRE_PER_SECOND_SQUARED)
        .mayTake("t", Type.NUMBER, Unit.SECOND, "until target speed is reached")
        .alias("t_min")
        .mayTake("aRot", Type.NUMBER, Unit.RADIAN_PER_SECOND_SQUARED, "a")
        .physicalTime()
        .does(ServoBuiltins::speedl);
  }

  private static void declareServos(Builtins<ControlBox> builtins) {
    builtins
        .declare("servoj")
        .manual(MODULE, "15.44")
        .doc(
            "Lets the joints run after positions that are given again and again, and waits for time"
                + " t. They lag by lookahead_time; gain says how hard they are drawn. a and v are"
                + " not used. Without another call the arm comes to rest.")
        .needs("q", Type.JOINTS)
        .mayTake("a", Type.NUMBER, Unit.RADIAN_PER_SECOND_SQUARED, "not used")
        .mayTake("v", Type.NUMBER, Unit.RADIAN_PER_SECOND, "not used")
        .takes("t", Unit.SECOND, FrameTime.FRAME_S)
        .takes("lookahead_time", Unit.SECOND, 0.1)
        .takes("gain", Unit.NONE, 300)
        .physicalTime()
        .does(ServoBuiltins::servoj);
    builtins
        .declare("servoc")
        .manual(MODULE, "15.44")
        .doc(
            "Leads the TCP to a pose on an arc that continues its present direction, and waits"
                + " until it rests there or is within r of it. From older manuals, for old"
                + " programs.")
        .needs("pose", Type.POSE_OR_JOINTS)
        .takes("a", Unit.METRE_PER_SECOND_SQUARED, 1.2)
        .takes("v", Unit.METRE_PER_SECOND, 0.25)
        .takes("r", Unit.METRE, 0)
        .deprecated("movep")
        .physicalTime()
        .does(ServoBuiltins::servoc);
  }

  private static Outcome speedj(Call<ControlBox> call) throws ScriptError {
    Joints speed = Joints.of(speeds(call, "eachRadPerS"));
    double acceleration = MotionArguments.positive(call, 1);
    return MotionWait.continueWith(
        call, "speedj", call.host().modes().servoing().speedJ(speed, acceleration, returnS(call)));
  }

  private static Outcome speedl(Call<ControlBox> call) throws ScriptError {
    double[] twist = speeds(call, "eachMPerS");
    double acceleration = MotionArguments.positive(call, 1);
    double turning = call.given(3) ? MotionArguments.positive(call, 3) : acceleration;
    Pose tcp = call.host().flange().tool().inFlange();
    return MotionWait.continueWith(
        call,
        "speedl",
        call.host().modes().servoing().speedL(tcp, twist, acceleration, turning, returnS(call)));
  }

  private static double[] speeds(Call<ControlBox> call, String refusal) throws ScriptError {
    return MotionArguments.bounded(call, 0, Joints.COUNT, MAX_SPEED, refusal);
  }

  private static OptionalDouble returnS(Call<ControlBox> call) throws ScriptError {
    return call.given(2)
        ? OptionalDouble.of(MotionArguments.notNegative(call, 2))
        : OptionalDouble.empty();
  }

  private static Outcome servoj(Call<ControlBox> call) throws ScriptError {
    Joints goal = MotionArguments.jointGoal(call, 0);
    unused(call, 1);
    unused(call, 2);
    double timeS = MotionArguments.notNegative(call, 3);
    double lookaheadS = within(call, 4, MIN_LOOKAHEAD_S, MAX_LOOKAHEAD_S, "rangeS");
    double gain = within(call, 5, MIN_GAIN, MAX_GAIN, "range");
    return MotionWait.continueWith(
        call, "servoj", call.host().modes().servoing().servoJ(goal, timeS, lookaheadS, gain));
  }

  /** An argument that nothing depends on is a number all the same. */
  private static void unused(Call<ControlBox> call, int index) throws ScriptError {
    if (call.given(index)) {
      call.number(index);
    }
  }

  private static double within(
      Call<ControlBox> call, int index, double least, double most, String refusal)
      throws ScriptError {
    double number = call.number(index);
    if (!(number >= least && number <= most)) {
      throw call.refuse(index, text(refusal, Value.of(least).text(), Value.of(most).text()));
    }
    return number;
  }

  private static Outcome servoc(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    Pose tcp = box.flange().tool().inFlange();
    Pose goal =
        call.kind(0) == ValueKind.POSE
            ? MotionArguments.pose(call, 0)
            : box.kinematics().forward().tcpPose(MotionArguments.jointGoal(call, 0), tcp);
    double acceleration = MotionArguments.positive(call, 1);
    double speed = MotionArguments.positive(call, 2);
    double radiusM = MotionArguments.notNegative(call, 3);
    return MotionWait.continueWith(
        call, "servoc", box.modes().servoing().servoC(goal, tcp, acceleration, speed, radiusM));
  }

  private static Outcome directTorque(Call<ControlBox> call) throws ScriptError {
    Joints torqueNm = MotionArguments.joints(call, 0);
    FrictionShare usual = call.bool(1) ? FrictionShare.MOST : FrictionShare.NONE;
    FrictionShare friction =
        new FrictionShare(share(call, 2, usual.viscous()), share(call, 3, usual.coulomb()));
    try {
      call.host().drive().requirePower();
      call.host().modes().servoing().giveTorque(torqueNm, friction);
    } catch (PlanningException e) {
      throw Planning.failure(call, e);
    } catch (ScriptError e) {
      throw call.failure(e.code(), e.getMessage());
    }
    long next = call.frame() + 1;
    Wait wait = frame -> frame >= next ? DONE : Optional.empty();
    return wait;
  }

  private static Joints share(Call<ControlBox> call, int index, Joints usual) throws ScriptError {
    if (!call.given(index)) {
      return usual;
    }
    Joints share = call.joints(index);
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!(share.get(i) >= 0 && share.get(i) <= 1)) {
        throw call.refuse(index, text("eachZeroToOne"));
      }
    }
    return share;
  }
}
