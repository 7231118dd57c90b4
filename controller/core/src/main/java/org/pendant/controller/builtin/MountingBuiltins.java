package org.pendant.controller.builtin;

import org.pendant.controller.box.ArmModel;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;

/** Mounting builtins: how the base is mounted and moves (manual 16.10, 16.14, 16.44, 16.48). */
final class MountingBuiltins {
  private static final String MODULE = "internals";

  /** Largest component of an acceleration, m/s²: ten times that of gravity. */
  private static final double MAX_M_PER_S2 = 100;

  private MountingBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_base_acceleration")
        .manual(MODULE, "16.10")
        .doc("The acceleration of the base that was set, along its axes, in m/s\u00b2.")
        .returns(Type.LIST)
        .effect(Effect.ASKS)
        .does(MountingBuiltins::baseAcceleration);
    builtins
        .declare("get_gravity")
        .manual(MODULE, "16.14")
        .doc(
            "The acceleration that the resting arm feels, away from the earth, along the axes of"
                + " the base, in m/s\u00b2.")
        .returns(Type.LIST)
        .effect(Effect.ASKS)
        .does(MountingBuiltins::gravity);
    builtins
        .declare("set_base_acceleration")
        .manual(MODULE, "16.44")
        .doc(
            "Tells how the base is accelerated, along its axes in m/s\u00b2, when the arm stands on"
                + " something that moves.")
        .needs("a", Type.LIST)
        .does(MountingBuiltins::setBaseAcceleration);
    builtins
        .declare("set_gravity")
        .manual(MODULE, "16.48")
        .doc(
            "Tells how the base is mounted: the acceleration that the resting arm feels, away from"
                + " the earth, along the axes of the base in m/s\u00b2.")
        .needs("d", Type.LIST)
        .does(MountingBuiltins::setGravity);
  }

  private static Outcome gravity(Call<ControlBox> call) {
    ArmModel model = call.host().arm().model();
    return call.answer(
        NumberList.of(model.gravityMPerS2(0), model.gravityMPerS2(1), model.gravityMPerS2(2)));
  }

  private static Outcome baseAcceleration(Call<ControlBox> call) {
    ArmModel model = call.host().arm().model();
    return call.answer(
        NumberList.of(
            model.baseAccelerationMPerS2(0),
            model.baseAccelerationMPerS2(1),
            model.baseAccelerationMPerS2(2)));
  }

  private static Outcome setGravity(Call<ControlBox> call) throws ScriptError {
    double[] d = acceleration(call);
    call.host().arm().setGravity(d[0], d[1], d[2]);
    return call.answer();
  }

  private static Outcome setBaseAcceleration(Call<ControlBox> call) throws ScriptError {
    double[] a = acceleration(call);
    call.host().arm().setBaseAcceleration(a[0], a[1], a[2]);
    return call.answer();
  }

  private static double[] acceleration(Call<ControlBox> call) throws ScriptError {
    return MotionArguments.bounded(call, 0, 3, MAX_M_PER_S2, "eachMPerS2");
  }
}
