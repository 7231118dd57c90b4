package org.pendant.controller.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Poses;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** Pose algebra (manual 17), which {@link Poses} computes. */
final class PoseBuiltins {
  /** Of rotations between their vectors and matrices. */
  private static final int TRANSFORM_NS = 120;

  private PoseBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("interpolate_pose")
        .manual("urmath", "17.13")
        .doc(
            "The pose at the fraction alpha of the straight way between two poses. Fractions below"
                + " 0 and above 1 extend the line.")
        .needs("p_from", Type.POSE)
        .needs("p_to", Type.POSE)
        .needs("alpha", Type.NUMBER)
        .returns(Type.POSE)
        .effect(Effect.COMPUTES)
        .costs(TRANSFORM_NS)
        .does(call -> call.answer(Poses.interpolate(call.pose(0), call.pose(1), call.number(2))));
    builtins
        .declare("point_dist")
        .manual("urmath", "17.19")
        .doc("The distance between the positions of two poses; rotations do not count.")
        .needs("p_from", Type.POSE)
        .needs("p_to", Type.POSE)
        .returns(Unit.METRE)
        .effect(Effect.COMPUTES)
        .does(call -> call.answer(Poses.pointDistance(call.pose(0), call.pose(1))));
    builtins
        .declare("pose_add")
        .manual("urmath", "17.20")
        .doc("Adds the positions of two poses and multiplies their rotations.")
        .needs("p_1", Type.POSE)
        .needs("p_2", Type.POSE)
        .returns(Type.POSE)
        .effect(Effect.COMPUTES)
        .costs(TRANSFORM_NS)
        .does(call -> call.answer(Poses.add(call.pose(0), call.pose(1))));
    builtins
        .declare("pose_dist")
        .manual("urmath", "17.21")
        .doc(
            "The distance of two poses: the larger of that of their positions in m and a quarter of"
                + " the angle between them in rad.")
        .needs("p_from", Type.POSE)
        .needs("p_to", Type.POSE)
        .returns(Type.NUMBER)
        .effect(Effect.COMPUTES)
        .costs(TRANSFORM_NS)
        .does(call -> call.answer(Poses.distance(call.pose(0), call.pose(1))));
    builtins
        .declare("pose_inv")
        .manual("urmath", "17.22")
        .doc("The inverse transformation: the origin's pose seen from p_from.")
        .needs("p_from", Type.POSE)
        .returns(Type.POSE)
        .effect(Effect.COMPUTES)
        .costs(TRANSFORM_NS)
        .does(call -> call.answer(Poses.inverse(call.pose(0))));
    builtins
        .declare("pose_sub")
        .manual("urmath", "17.23")
        .doc("Subtracts the positions of two poses, and gives the rotation that leads to p_to.")
        .needs("p_to", Type.POSE)
        .needs("p_from", Type.POSE)
        .returns(Type.POSE)
        .effect(Effect.COMPUTES)
        .costs(TRANSFORM_NS)
        .does(call -> call.answer(Poses.sub(call.pose(0), call.pose(1))));
    builtins
        .declare("pose_trans")
        .manual("urmath", "17.24")
        .doc("The pose reached from p_from by a move of p_from_to in the frame of p_from.")
        .needs("p_from", Type.POSE)
        .needs("p_from_to", Type.POSE)
        .returns(Type.POSE)
        .effect(Effect.COMPUTES)
        .costs(TRANSFORM_NS)
        .does(call -> call.answer(Poses.trans(call.pose(0), call.pose(1))));
  }
}
