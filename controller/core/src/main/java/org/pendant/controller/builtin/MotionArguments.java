package org.pendant.controller.builtin;

import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MoveLimits;
import org.pendant.script.function.Call;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Motion arguments: checks of what programs hand to the functions that move or locate the arm. */
final class MotionArguments {
  /** Products of larger numbers would overflow, and make a pose of NaN of a finite one. */
  private static final double MAX_IN_POSE = 1e100;

  /** Farthest position of a joint, rad: positions stay exact. */
  private static final double MAX_RAD = 10_000;

  /** Keys of the names of the joints. */
  private static final List<String> JOINTS =
      List.of("base", "shoulder", "elbow", "wrist1", "wrist2", "wrist3");

  private MotionArguments() {}

  /** A number above 0. */
  static double positive(Call<ControlBox> call, int index) throws ScriptError {
    double number = call.number(index);
    if (!(number > 0) || Double.isInfinite(number)) {
      throw call.refuse(index, BuiltinTexts.text("positive"));
    }
    return number;
  }

  /** A finite number of 0 or more. */
  static double notNegative(Call<ControlBox> call, int index) throws ScriptError {
    double number = call.number(index);
    if (!(number >= 0) || Double.isInfinite(number)) {
      throw call.refuse(index, BuiltinTexts.text("notNegative"));
    }
    return number;
  }

  /** A pose of finite numbers. */
  static Pose pose(Call<ControlBox> call, int index) throws ScriptError {
    return finite(call, index, call.pose(index));
  }

  /** A pose from argument {@code index}, whose numbers must be finite, and so their squares. */
  static Pose finite(Call<ControlBox> call, int index, Pose pose) throws ScriptError {
    for (int i = 0; i < Pose.SIZE; i++) {
      if (!Double.isFinite(pose.get(i))) {
        throw call.refuse(index, BuiltinTexts.text("finite"));
      }
      if (Math.abs(pose.get(i)) > MAX_IN_POSE) {
        throw call.refuse(index, BuiltinTexts.text("within1e100"));
      }
    }
    return pose;
  }

  /**
   * A list of {@code length} numbers, none of them further from 0 than {@code bound}.
   *
   * @param refusal key of the text that refuses others, which is filled with the bound
   */
  static double[] bounded(
      Call<ControlBox> call, int index, int length, double bound, String refusal)
      throws ScriptError {
    double[] numbers = call.numbers(index, length);
    for (double number : numbers) {
      if (!(Math.abs(number) <= bound)) {
        String limit = text(bound);
        throw call.refuse(index, BuiltinTexts.text(refusal, limit, limit));
      }
    }
    return numbers;
  }

  /** Six finite joint values. */
  static Joints joints(Call<ControlBox> call, int index) throws ScriptError {
    Joints joints = call.joints(index);
    if (!joints.isFinite()) {
      throw call.refuse(index, BuiltinTexts.text("finite"));
    }
    return joints;
  }

  /**
   * Six joint positions to go to or to be near to. They may lie beyond the ranges of the joints:
   * the arm stops before.
   */
  static Joints jointGoal(Call<ControlBox> call, int index) throws ScriptError {
    return Joints.of(bounded(call, index, Joints.COUNT, MAX_RAD, "eachRad"));
  }

  /** Six joint positions, each within the range of its joint. */
  static Joints jointsInRange(Call<ControlBox> call, int index, String name) throws ScriptError {
    Joints joints = joints(call, index);
    List<JointLimits> limits = call.host().arm().description().joints();
    for (int i = 0; i < Joints.COUNT; i++) {
      JointLimits limit = limits.get(i);
      if (!limit.contains(joints.get(i))) {
        throw call.failure(
            "joint-out-of-range",
            BuiltinTexts.text(
                "jointOutOfRange",
                name,
                i,
                BuiltinTexts.text(JOINTS.get(i)),
                text(joints.get(i)),
                text(limit.lowestRad()),
                text(limit.highestRad())));
      }
    }
    return joints;
  }

  private static String text(double number) {
    return Value.of(number).text();
  }

  /** Joint positions to be near to: argument {@code index}, or the present target without one. */
  static Joints near(Call<ControlBox> call, int index) throws ScriptError {
    boolean absent =
        !call.given(index) || (call.value(index) instanceof ListValue list && list.length() == 0);
    return absent ? call.host().motion().positionRad() : joints(call, index);
  }

  /** A TCP offset: argument {@code index}, or the active one without it. */
  static Pose tcpOffset(Call<ControlBox> call, int index) throws ScriptError {
    return call.given(index) ? pose(call, index) : call.host().flange().tool().inFlange();
  }

  /**
   * Arguments a, v and t of a move, from {@code index} on. When t is given, a and v may be 0: the
   * move then takes what acceleration it needs.
   */
  static MoveLimits moveLimits(Call<ControlBox> call, int index) throws ScriptError {
    double durationS = notNegative(call, index + 2);
    boolean timed = durationS > 0;
    double acceleration = timed ? notNegative(call, index) : positive(call, index);
    double speed = timed ? notNegative(call, index + 1) : positive(call, index + 1);
    return new MoveLimits(acceleration, speed, durationS);
  }
}
