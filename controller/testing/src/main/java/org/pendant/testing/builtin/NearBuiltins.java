package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Assertions about numbers, joints and poses that need not agree to the last digit. */
final class NearBuiltins {
  private static final String SECTION = "Assertions";
  private static final double MM_PER_M = 1000;

  private NearBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "assert_near", SECTION)
        .doc(
            "Fails the test unless two numbers, or all elements of two lists of numbers, differ by"
                + " the tolerance at most.")
        .needs("actual", Type.ANY)
        .needs("expected", Type.ANY)
        .takes("tolerance", Type.NUMBER, Value.of(1e-6))
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(NearBuiltins::near);
    TestBuiltins.declare(builtins, "assert_joints_near", SECTION)
        .doc("Fails the test unless each of six joints is within so many degrees of another.")
        .needs("actual", Type.JOINTS)
        .needs("expected", Type.JOINTS)
        .takes("deg", Type.NUMBER, Value.of(0.1))
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(NearBuiltins::joints);
    TestBuiltins.declare(builtins, "assert_pose_near", SECTION)
        .doc(
            "Fails the test unless the positions of two poses are so many millimetres apart at"
                + " most, and their orientations so many degrees.")
        .needs("actual", Type.POSE)
        .needs("expected", Type.POSE)
        .takes("mm", Type.NUMBER, Value.of(0.1))
        .takes("deg", Type.NUMBER, Value.of(0.1))
        .takes("message", Type.STRING, Value.of(""))
        .effect(Effect.COMPUTES)
        .does(NearBuiltins::poses);
    TestBuiltins.declare(builtins, "tcp_inside", SECTION)
        .doc(
            "Whether the TCP is inside a box along the axes of the base, given by two opposite"
                + " corners.")
        .needs("corner", Type.ANY)
        .needs("opposite", Type.ANY)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> inside(call, call.host().kinematics().actualTcpInBase()));
    TestBuiltins.declare(builtins, "min_distance", SECTION)
        .doc(
            "How far a link of the arm is from another link, from an object of the scene that"
                + " stands still, or from another arm, at the nearest; negative where it is"
                + " inside. What no joint can make larger does not count: the shoulder above a"
                + " floor, or the upper arm while it points up from it.")
        .returns(Unit.METRE)
        .effect(Effect.SENSES)
        .does(
            call ->
                call.answer(
                    call.host()
                        .arm()
                        .nearestM(
                            call.host().drive().actualPositionRad(),
                            call.host().flange().tool().inFlange())));
    TestBuiltins.declare(builtins, "robot_time", SECTION)
        .doc("How long the test has been running, in s of robot time.")
        .returns(Unit.SECOND)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().clock().timeS()));
  }

  private static double tolerance(Call<ControlBox> call, int index) throws ScriptError {
    double tolerance = call.number(index);
    if (!(tolerance >= 0)) {
      throw call.refuse(index, text("notNegative"));
    }
    return tolerance;
  }

  private static Outcome near(Call<ControlBox> call) throws ScriptError {
    double tolerance = tolerance(call, 2);
    if (call.value(0) instanceof NumberList || call.value(1) instanceof NumberList) {
      return listsNear(call, tolerance);
    }
    double actual = call.number(0);
    double expected = call.number(1);
    if (!(Math.abs(actual - expected) <= tolerance)) {
      throw AssertionBuiltins.failure(call, text("notNear", actual, expected, tolerance), 3);
    }
    return call.answer();
  }

  private static Outcome listsNear(Call<ControlBox> call, double tolerance) throws ScriptError {
    double[] actual = call.numbers(0, -1);
    double[] expected = call.numbers(1, -1);
    if (actual.length != expected.length) {
      throw AssertionBuiltins.failure(
          call, text("elementCount", actual.length, expected.length), 3);
    }
    for (int i = 0; i < actual.length; i++) {
      if (!(Math.abs(actual[i] - expected[i]) <= tolerance)) {
        throw AssertionBuiltins.failure(
            call, text("elementNotNear", i, actual[i], expected[i], tolerance), 3);
      }
    }
    return call.answer();
  }

  private static Outcome joints(Call<ControlBox> call) throws ScriptError {
    double deg = tolerance(call, 2);
    double[] actual = call.numbers(0, 6);
    double[] expected = call.numbers(1, 6);
    for (int i = 0; i < actual.length; i++) {
      double off = Math.toDegrees(actual[i] - expected[i]);
      if (!(Math.abs(off) <= deg)) {
        throw AssertionBuiltins.failure(
            call, text("jointNotNear", i, actual[i], expected[i], rounded(Math.abs(off)), deg), 3);
      }
    }
    return call.answer();
  }

  private static Outcome poses(Call<ControlBox> call) throws ScriptError {
    double mm = tolerance(call, 2);
    double deg = tolerance(call, 3);
    Pose actual = call.pose(0);
    Pose expected = call.pose(1);
    double apartMm = MM_PER_M * Poses.pointDistance(actual, expected);
    double turnedDeg = Math.toDegrees(Poses.rotationAngle(actual, expected));
    if (!(apartMm <= mm && turnedDeg <= deg)) {
      throw AssertionBuiltins.failure(
          call,
          text(
              "poseNotNear",
              AssertionBuiltins.shown(call.value(0)),
              AssertionBuiltins.shown(call.value(1)),
              rounded(apartMm),
              rounded(turnedDeg),
              mm,
              deg),
          4);
    }
    return call.answer();
  }

  private static double rounded(double value) {
    return Math.round(value * 1e4) / 1e4;
  }

  /** Whether the TCP is inside the box that the arguments are. */
  static Outcome inside(Call<ControlBox> call, Pose tcp) throws ScriptError {
    double[] one = corner(call, 0);
    double[] other = corner(call, 1);
    double[] at = {tcp.x(), tcp.y(), tcp.z()};
    boolean inside = true;
    for (int i = 0; i < at.length; i++) {
      inside &= at[i] >= Math.min(one[i], other[i]) && at[i] <= Math.max(one[i], other[i]);
    }
    return call.answer(inside);
  }

  private static double[] corner(Call<ControlBox> call, int index) throws ScriptError {
    if (call.kind(index) == ValueKind.POSE) {
      Pose pose = call.pose(index);
      return new double[] {pose.x(), pose.y(), pose.z()};
    }
    return call.numbers(index, 3);
  }
}
