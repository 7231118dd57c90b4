package org.pendant.testing.builtin;

import org.pendant.controller.bench.Choices;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ListValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/**
 * Generators: values that differ from run to run of a test that is marked with {@code @given}. The
 * simplest value of each is the one that choices of 0 make.
 */
final class GeneratorBuiltins {
  private static final String SECTION = "Generators";

  /** How far from their middle joints are turned: half a turn, as cables allow it. */
  private static final double MAX_TURN_RAD = Math.PI;

  private GeneratorBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "any_number", SECTION)
        .doc("A number from low to high; the simplest is 0, or the limit next to it.")
        .needs("low", Type.NUMBER)
        .needs("high", Type.NUMBER)
        .returns(Type.NUMBER)
        .does(GeneratorBuiltins::number);
    TestBuiltins.declare(builtins, "any_int", SECTION)
        .doc("A whole number from low to high, both included.")
        .needs("low", Type.INT)
        .needs("high", Type.INT)
        .returns(Type.INT)
        .does(GeneratorBuiltins::integer);
    TestBuiltins.declare(builtins, "any_bool", SECTION)
        .doc("True or False; the simpler is False.")
        .returns(Type.BOOL)
        .does(
            call -> {
              boolean value = choices(call).next() >= 0.5;
              return told(call, Value.of(value), call.answer(value));
            });
    TestBuiltins.declare(builtins, "any_of", SECTION)
        .doc("An element of a list; the simplest is the first.")
        .needs("list", Type.LIST)
        .returns(Type.ANY)
        .does(GeneratorBuiltins::element);
    TestBuiltins.declare(builtins, "any_joints", SECTION)
        .doc("Six joint positions that the arm can have, within half a turn of 0.")
        .returns(Type.JOINTS)
        .does(
            call -> {
              Joints joints = joints(call);
              return told(call, text(joints.toString()), call.answer(joints));
            });
    TestBuiltins.declare(builtins, "any_pose_in_reach", SECTION)
        .doc("A pose of the TCP that the arm can reach.")
        .returns(Type.POSE)
        .does(GeneratorBuiltins::pose);
    TestBuiltins.declare(builtins, "assume", SECTION)
        .doc("Drops this run of the test, which counts as none, unless the condition holds.")
        .needs("condition", Type.BOOL)
        .does(
            call -> {
              if (!call.bool(0)) {
                throw new ScriptError(AssertionCodes.DROPPED, TestTexts.text("assumed"));
              }
              return call.answer();
            });
  }

  private static Choices choices(Call<ControlBox> call) {
    return TestBuiltins.bench(call).choices();
  }

  private static Value text(String text) {
    return Value.of(text);
  }

  private static Outcome told(Call<ControlBox> call, Value value, Outcome answer) {
    choices(call).tell(value.text());
    return answer;
  }

  private static Outcome number(Call<ControlBox> call) throws ScriptError {
    double low = call.number(0);
    double high = call.number(1);
    if (!(low <= high && Double.isFinite(high - low))) {
      throw call.refuse(1, TestTexts.text("notBelowLow"));
    }
    double value = scaled(choices(call).next(), low, high);
    return told(call, Value.of(value), call.answer(value));
  }

  /** A number of a range, the nearer to 0 the smaller the choice. */
  private static double scaled(double choice, double low, double high) {
    if (low >= 0) {
      return low + choice * (high - low);
    }
    if (high <= 0) {
      return high - choice * (high - low);
    }
    // the lower half of choices is above 0, the upper half below, either the nearer the smaller
    double both = choice * 2;
    return both < 1 ? both * high : (both - 1) * low;
  }

  private static Outcome integer(Call<ControlBox> call) throws ScriptError {
    int low = call.integer(0);
    int high = call.integer(1);
    if (low > high) {
      throw call.refuse(1, TestTexts.text("notBelowLow"));
    }
    double choice = choices(call).next();
    double wide = scaled(choice, (double) low, high + (low >= 0 ? 1.0 : 0.0));
    int value = Math.clamp((long) (wide < 0 ? Math.ceil(wide) : Math.floor(wide)), low, high);
    return told(call, Value.of(value), call.answerInt(value));
  }

  private static Outcome element(Call<ControlBox> call) throws ScriptError {
    ListValue list = call.list(0);
    if (list.length() == 0) {
      throw call.refuse(0, TestTexts.text("noElement"));
    }
    Value value = list.get((int) (choices(call).next() * list.length())).copy();
    return told(call, value, call.answer(value));
  }

  private static Joints joints(Call<ControlBox> call) {
    double[] positions = new double[6];
    for (int i = 0; i < positions.length; i++) {
      JointLimits limits = call.host().arm().description().joints().get(i);
      double low = Math.max(limits.minRad(), -MAX_TURN_RAD);
      double high = Math.min(limits.maxRad(), MAX_TURN_RAD);
      positions[i] = scaled(choices(call).next(), low, high);
    }
    return Joints.of(positions);
  }

  private static Outcome pose(Call<ControlBox> call) {
    Pose pose =
        call.host()
            .kinematics()
            .forward()
            .tcpPose(joints(call), call.host().flange().tool().inFlange());
    Outcome answer = call.answer(pose);
    choices(call).tell(pose.toString());
    return answer;
  }
}
