package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Published;
import org.pendant.language.check.Nearest;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Published state builtins: what clients of the real-time data exchange see (manual 18.10). */
final class PublishedBuiltins {
  private PublishedBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_rtde_value")
        .manual("interfaces", "18.10")
        .doc(
            "The value of an RTDE output field, as clients got it at the end of the frame before:"
                + " a bool, a number, or a list of three or six numbers.")
        .needs("key", Type.STRING)
        .returns(Type.ANY)
        .effect(Effect.SENSES)
        .does(PublishedBuiltins::rtdeValue);
  }

  private static Outcome rtdeValue(Call<ControlBox> call) throws ScriptError {
    String key = call.text(0);
    if (key.equals(Published.EXECUTION_TIME)) {
      call.host().clock().determinism().loseInRealTime(text("askedComputerTime"));
    }
    Published published = call.host().links().published();
    Value value =
        published
            .field(key)
            .orElseThrow(
                () ->
                    call.refuse(
                        0,
                        new Nearest()
                            .to(key, published::fieldNames)
                            .map(name -> text("fieldNameSuchAs", name))
                            .orElseGet(() -> text("fieldName"))));
    return call.answer(value);
  }
}
