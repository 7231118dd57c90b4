package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.StopJ;
import org.pendant.motion.offset.OffsetType;
import org.pendant.motion.offset.PathOffsetting;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Offsets over the path of moves (manual 15.34 to 15.39). */
final class PathOffsetBuiltins {
  private static final String MODULE = "motion";

  private static final int LAST_TYPE = OffsetType.values().length;

  private PathOffsetBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareUse(builtins);
    declareSettings(builtins);
  }

  private static void declareUse(Builtins<ControlBox> builtins) {
    builtins
        .declare("path_offset_enable")
        .manual(MODULE, "15.35")
        .doc(
            "Begins to shift the tool by what path_offset_set says, besides all moves. It goes"
                + " neither with conveyor tracking nor with force mode.")
        .does(PathOffsetBuiltins::enable);
    builtins
        .declare("path_offset_disable")
        .manual(MODULE, "15.34")
        .doc("Ends path offset, slows all joints down in proportion and waits until they rest.")
        .takes("a", Unit.RADIAN_PER_SECOND_SQUARED, 20)
        .physicalTime()
        .does(PathOffsetBuiltins::disable);
    builtins
        .declare("path_offset_set")
        .manual(MODULE, "15.37")
        .doc(
            "Sets the offset: along the axes of the base (type 1), of the TCP (2) or of the path"
                + " (3: x forward, y across it and the tool's z axis), or as the pose of the base"
                + " in a world in which moves are meant (4).")
        .needs("offset", Type.POSE_OR_JOINTS)
        .needs("type", Type.INT)
        .does(PathOffsetBuiltins::set);
    builtins
        .declare("path_offset_get")
        .manual(MODULE, "15.36")
        .doc("The offset that is applied now, in the frame of a type of path_offset_set.")
        .needs("type", Type.INT)
        .returns(Type.POSE)
        .effect(Effect.ASKS)
        .does(call -> call.answer(call.host().offsets().path().applied(type(call, 0))));
  }

  private static void declareSettings(Builtins<ControlBox> builtins) {
    builtins
        .declare("path_offset_set_alpha_filter")
        .manual(MODULE, "15.38")
        .doc(
            "Sets how much of the way to the offset is gone in each frame, 0 to 1; at first 1,"
                + " which is all of it.")
        .needs("alpha", Type.NUMBER)
        .does(PathOffsetBuiltins::setAlpha);
    builtins
        .declare("path_offset_set_max_offset")
        .manual(MODULE, "15.39")
        .doc(
            "Sets how far an offset may shift along each axis and turn about it, at first 0.1 m and"
                + " 0.52 rad; what goes beyond is cut off.")
        .needs("transLimit", Unit.METRE)
        .needs("rotLimit", Unit.RADIAN)
        .does(PathOffsetBuiltins::setLimits);
  }

  private static OffsetType type(Call<ControlBox> call, int index) throws ScriptError {
    return OffsetType.of(call.integer(index, 1, LAST_TYPE));
  }

  private static Outcome enable(Call<ControlBox> call) throws ScriptError {
    ControlBox box = call.host();
    PathOffsetting offset = box.offsets().path();
    if (box.offsets().conveyor().active()) {
      throw call.failure("conveyor-tracked", text("conveyorTracked"));
    }
    if (box.modes().forceMode().active()) {
      throw call.failure("force-mode", text("forceModeActive"));
    }
    if (box.motion().guided()) {
      throw call.failure("freedrive", text("inFreedrive"));
    }
    offset.enable();
    return call.answer();
  }

  private static Outcome disable(Call<ControlBox> call) throws ScriptError {
    double deceleration = MotionArguments.positive(call, 0);
    Planning.act(call, () -> call.host().motion().endOffset(call.host().offsets().path()));
    return MotionWait.stop(
        call, "path_offset_disable", (from, speed) -> new StopJ(from, speed, deceleration));
  }

  private static Outcome set(Call<ControlBox> call) throws ScriptError {
    Pose offset =
        call.kind(0) == ValueKind.POSE ? call.pose(0) : Pose.of(call.numbers(0, Pose.SIZE));
    call.host().offsets().path().set(MotionArguments.finite(call, 0, offset), type(call, 1));
    return call.answer();
  }

  private static Outcome setAlpha(Call<ControlBox> call) throws ScriptError {
    double alpha = call.number(0);
    if (!(alpha >= 0 && alpha <= 1)) {
      throw call.refuse(0, text("zeroToOne"));
    }
    call.host().offsets().path().setAlpha(alpha);
    return call.answer();
  }

  private static Outcome setLimits(Call<ControlBox> call) throws ScriptError {
    double shiftM = MotionArguments.notNegative(call, 0);
    double turnRad = MotionArguments.notNegative(call, 1);
    call.host().offsets().path().setLimits(shiftM, turnRad);
    return call.answer();
  }
}
