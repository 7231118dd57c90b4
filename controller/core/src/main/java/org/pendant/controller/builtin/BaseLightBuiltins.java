package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.BaseLight;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.models.arm.Series;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/**
 * Base light builtins: the light ring in the base of the UR-Series (manual 16.45 to 16.47); other
 * arms have none.
 */
final class BaseLightBuiltins {
  private static final String MODULE = "internals";
  private static final int BRIGHTEST = 255;

  private BaseLightBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declare(builtins, "set_baselight_iec", "16.46")
        .doc("Lets the light in the base show modes and stops as IEC 60204-1 asks.")
        .does(call -> show(call, BaseLight.STANDARD));
    declare(builtins, "set_baselight_off", "16.45")
        .doc("Turns the light in the base off.")
        .does(call -> show(call, BaseLight.OFF));
    declare(builtins, "set_baselight_solid", "16.47")
        .doc("Gives the light in the base one colour of red, green and blue, 0 to 255 each.")
        .needs("r", Type.INT)
        .needs("g", Type.INT)
        .needs("b", Type.INT)
        .does(BaseLightBuiltins::solid);
  }

  private static Declaration<ControlBox> declare(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins.declare(name).manual(MODULE, section);
  }

  private static Outcome solid(Call<ControlBox> call) throws ScriptError {
    return show(
        call,
        new BaseLight.Solid(
            call.integer(0, 0, BRIGHTEST),
            call.integer(1, 0, BRIGHTEST),
            call.integer(2, 0, BRIGHTEST)));
  }

  private static Outcome show(Call<ControlBox> call, BaseLight light) {
    if (call.host().arm().description().series() == Series.UR_SERIES) {
      call.host().arm().setBaseLight(light);
    } else {
      call.host().log().warnOnce(text("noBaseLight", call.host().arm().description().id()));
    }
    return call.answer();
  }
}
