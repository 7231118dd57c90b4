package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.freedrive.FreedriveMode;
import org.pendant.controller.freedrive.FreedriveStart;
import org.pendant.language.signature.Type;
import org.pendant.models.pose.Pose;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Freedrive builtins: guiding the arm by hand (manual 15.9, 15.11, 15.18, 15.19, 15.21, 15.55). */
final class FreedriveBuiltins {
  private static final String MODULE = "motion";

  private FreedriveBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("freedrive_mode")
        .manual(MODULE, "15.18")
        .doc(
            "Lets the arm be guided by hand, until it is ended or the program pauses or stops; no"
                + " move can start meanwhile. freeAxes has a 1 for each axis x, y, z, rx, ry, rz of"
                + " the feature that is free; feature is a pose in the base frame, \"base\" or"
                + " \"tool\". A wrong payload is a protective stop.")
        .takes("freeAxes", Type.LIST, NumberList.ofInts(1, 1, 1, 1, 1, 1))
        .takes("feature", Type.ANY, new PoseValue(Pose.ZERO))
        .does(FreedriveBuiltins::freedrive);
    builtins
        .declare("freedrive_mode_no_incorrect_payload_check")
        .manual(MODULE, "15.19")
        .doc(
            "Lets the arm be guided by hand along all axes and does not look whether the payload is"
                + " right; with a wrong one the arm drifts.")
        .does(call -> start(call, FreedriveMode.free(FreedriveHolder.PROGRAM, false)));
    builtins
        .declare("teach_mode")
        .manual(MODULE, "15.55")
        .doc("Lets the arm be guided by hand along all axes.")
        .deprecated("freedrive_mode")
        .does(call -> start(call, FreedriveMode.free(FreedriveHolder.PROGRAM, true)));
    builtins
        .declare("end_freedrive_mode")
        .manual(MODULE, "15.9")
        .doc("Ends freedrive: the arm holds where it is.")
        .does(FreedriveBuiltins::end);
    builtins
        .declare("end_teach_mode")
        .manual(MODULE, "15.11")
        .doc("Ends freedrive: the arm holds where it is.")
        .deprecated("end_freedrive_mode")
        .does(FreedriveBuiltins::end);
    builtins
        .declare("get_freedrive_status")
        .manual(MODULE, "15.21")
        .doc(
            "How near the arm is to a singularity, where locked axes make it hard to guide: 0 far"
                + " away, 1 near, 2 too close.")
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(call -> call.answerInt(call.host().modes().freedrive().singularity().code()));
  }

  private static Outcome freedrive(Call<ControlBox> call) throws ScriptError {
    return start(call, new FreedriveMode(FreedriveHolder.PROGRAM, axes(call), frame(call), true));
  }

  private static FreeAxes axes(Call<ControlBox> call) throws ScriptError {
    double[] numbers = call.numbers(0, FreeAxes.COUNT);
    FreeAxes axes = FreeAxes.ALL;
    for (int i = 0; i < FreeAxes.COUNT; i++) {
      if (numbers[i] != 0 && numbers[i] != 1) {
        throw call.refuse(0, text("freeAxes"));
      }
      axes = axes.with(i, numbers[i] == 1);
    }
    return axes;
  }

  private static FreedriveFrame frame(Call<ControlBox> call) throws ScriptError {
    if (call.kind(1) == ValueKind.POSE) {
      return new FreedriveFrame.Feature(MotionArguments.pose(call, 1));
    }
    if (call.kind(1) != ValueKind.STRING) {
      throw call.wrongKind(1, text("poseBaseOrTool"));
    }
    return switch (call.word(1)) {
      case "base" -> FreedriveFrame.BASE;
      case "tool" -> FreedriveFrame.TOOL;
      default -> throw call.refuse(1, text("mustBePoseBaseOrTool"));
    };
  }

  private static Outcome start(Call<ControlBox> call, FreedriveMode mode) throws ScriptError {
    switch (call.host().modes().freedrive().start(mode)) {
      case FreedriveStart.Started _ -> {}
      case FreedriveStart.Refused refused ->
          throw call.failure("freedrive-refused", refused.refusal().text());
      case FreedriveStart.WrongPayload wrong -> {
        call.host().safety().wrongPayload(wrong.errorN(), wrong.toleranceN());
        // the stop takes effect later in this frame: until then the program must not continue
        call.program().pause();
      }
    }
    return call.answer();
  }

  private static Outcome end(Call<ControlBox> call) {
    call.host().modes().freedrive().end();
    return call.answer();
  }
}
