package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Wrench;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;

/**
 * Functions of vectors: lists of numbers that mean a direction, a rotation or a force (manual 17).
 */
final class VectorBuiltins {
  private static final int SPACE = 3;
  private static final int WRENCH = 6;

  private VectorBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("norm")
        .manual("urmath", "17.17")
        .doc(
            "The magnitude of a number, or the root of the summed squares of a list of numbers or"
                + " of a pose's six components. The result for an int is an int.")
        .needs("a", Type.ANY)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .does(VectorBuiltins::norm);
    builtins
        .declare("normalize")
        .manual("urmath", "17.18")
        .doc("The vector of length 1 in the direction of v. It is an error when v is all zeros.")
        .needs("v", Type.LIST)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(VectorBuiltins::normalize);
    builtins
        .declare("rotvec2rpy")
        .manual("urmath", "17.28")
        .doc(
            "The roll, pitch and yaw, in rad, of a rotation vector. They are turns about the fixed"
                + " axes x, y and z in this order.")
        .needs("rotation_vector", Type.LIST)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(VectorBuiltins::rollPitchYaw);
    builtins
        .declare("rpy2rotvec")
        .manual("urmath", "17.29")
        .doc(
            "The rotation vector, in rad, of roll, pitch and yaw. These are turns about the fixed"
                + " axes x, y and z in this order.")
        .needs("rpy_vector", Type.LIST)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(VectorBuiltins::rotationVector);
    builtins
        .declare("wrench_trans")
        .manual("urmath", "17.35")
        .doc(
            "The same load seen from another frame: T_from_to is that frame's pose in the present"
                + " one, w_from three forces in N and three torques in Nm.")
        .needs("T_from_to", Type.POSE)
        .needs("w_from", Type.LIST)
        .returns(Type.LIST)
        .effect(Effect.COMPUTES)
        .does(VectorBuiltins::wrenchSeenFrom);
  }

  private static Outcome norm(Call<?> call) throws ScriptError {
    return switch (call.value(0)) {
      case IntValue i when i.value() == Integer.MIN_VALUE ->
          throw call.refuse(0, text("magnitude"));
      case IntValue i -> call.answerInt(Math.abs(i.value()));
      case FloatValue f -> call.answer(Math.abs(f.value()));
      case PoseValue pose -> call.answer(length(pose.pose()));
      case NumberList list when list.elementKind().isNumber() -> call.answer(length(list));
      default -> throw call.wrongKind(0, text("numberPoseOrNumbers"));
    };
  }

  private static Outcome normalize(Call<?> call) throws ScriptError {
    double[] v = call.numbers(0, -1);
    double squares = 0;
    for (double component : v) {
      squares += component * component;
    }
    if (squares == 0) {
      throw call.refuse(0, text("notAllZero"));
    }
    double length = Math.sqrt(squares);
    for (int i = 0; i < v.length; i++) {
      v[i] /= length;
    }
    return call.answer(NumberList.of(v));
  }

  private static Outcome rollPitchYaw(Call<?> call) throws ScriptError {
    double[] v = call.numbers(0, SPACE);
    Rotations.vectorToRpy(v[0], v[1], v[2], v);
    return call.answer(NumberList.of(v));
  }

  private static Outcome rotationVector(Call<?> call) throws ScriptError {
    double[] v = call.numbers(0, SPACE);
    Rotations.rpyToVector(v[0], v[1], v[2], v);
    return call.answer(NumberList.of(v));
  }

  private static Outcome wrenchSeenFrom(Call<?> call) throws ScriptError {
    double[] w = call.numbers(1, WRENCH);
    Wrench seen = new Wrench(w[0], w[1], w[2], w[3], w[4], w[5]).seenFrom(call.pose(0));
    return call.answer(
        NumberList.of(seen.fx(), seen.fy(), seen.fz(), seen.mx(), seen.my(), seen.mz()));
  }

  private static double length(NumberList list) {
    double squares = 0;
    for (int i = 0; i < list.length(); i++) {
      squares += list.numberAt(i) * list.numberAt(i);
    }
    return Math.sqrt(squares);
  }

  private static double length(Pose p) {
    return Math.sqrt(
        p.x() * p.x()
            + p.y() * p.y()
            + p.z() * p.z()
            + p.rx() * p.rx()
            + p.ry() * p.ry()
            + p.rz() * p.rz());
  }
}
