package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.MotionSettings;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Motion setting builtins: how moves are planned: motion version and jerk (manual 14). */
final class MotionSettingBuiltins {
  private static final String MODULE = "motion";

  private MotionSettingBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("motion_version_get")
        .manual(MODULE, "15.26")
        .doc("The motion version by which movej and movel are planned, 1 or 2.")
        .returns(Type.INT)
        .effect(Effect.ASKS)
        .does(call -> call.answerInt(settings(call).version()));
    builtins
        .declare("motion_version_set")
        .manual(MODULE, "15.27")
        .doc(
            "Sets the motion version by which movej and movel are planned until the controller is"
                + " switched off: 1 changes speeds by even acceleration, 2 limits the jerk and"
                + " makes blends smaller rather than leaving moves out.")
        .needs("version", Type.INT)
        .does(MotionSettingBuiltins::setVersion);
    builtins
        .declare("jerk_gain_scaling_get")
        .manual(MODULE, "15.24")
        .doc("The share of the usual jerk that moves of limited jerk may have, 0.01 to 1.")
        .returns(Type.NUMBER)
        .effect(Effect.ASKS)
        .does(call -> call.answer(settings(call).jerkGain()));
    builtins
        .declare("jerk_gain_scaling_set")
        .manual(MODULE, "15.25")
        .doc(
            "Sets the share of the usual jerk that moves of limited jerk may have, until the"
                + " controller is switched off: less is smoother and takes longer.")
        .takes("gain", Unit.NONE, 1)
        .does(MotionSettingBuiltins::setJerkGain);
  }

  private static MotionSettings settings(Call<ControlBox> call) {
    return call.host().planning().settings();
  }

  private static Outcome setVersion(Call<ControlBox> call) throws ScriptError {
    int version = call.integer(0);
    if (!settings(call).setVersion(version)) {
      call.host()
          .log()
          .warning(
              text(
                  "noMotionVersion",
                  call.host().arm().description().id(),
                  version,
                  settings(call).version()));
    }
    return call.answer();
  }

  private static Outcome setJerkGain(Call<ControlBox> call) throws ScriptError {
    double gain = call.number(0);
    if (!(gain >= MotionSettings.MIN_JERK_GAIN && gain <= 1)) {
      throw call.refuse(0, text("jerkGain"));
    }
    settings(call).setJerkGain(gain);
    return call.answer();
  }
}
