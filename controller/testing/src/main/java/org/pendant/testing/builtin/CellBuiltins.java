package org.pendant.testing.builtin;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Devices of the cell that answer programs, and the parts in their fingers. */
final class CellBuiltins {
  private static final String SECTION = "Devices of the cell";
  private static final String NO_DEVICE = "no-such-device";

  private CellBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "add_device", SECTION)
        .doc(
            "Puts a device into the cell that answers programs in robot time, called by its kind,"
                + " as --device of the command line does: "
                + String.join(", ", DeviceSetup.KINDS)
                + ".")
        .needs("kind", Type.STRING)
        .does(CellBuiltins::add);
    TestBuiltins.declare(builtins, "put_part", SECTION)
        .doc("Puts a part of a width between the fingers of a gripper; 0 takes it away.")
        .needs("device", Type.STRING)
        .needs("width", Unit.METRE)
        .does(
            call -> {
              try {
                call.host().links().devices().putPart(call.text(0), call.number(1));
              } catch (IllegalArgumentException e) {
                throw call.failure(NO_DEVICE, e.getMessage());
              }
              return call.answer();
            });
    TestBuiltins.declare(builtins, "finger_opening", SECTION)
        .doc("How far the fingers of a gripper are open.")
        .needs("device", Type.STRING)
        .returns(Unit.METRE)
        .effect(Effect.SENSES)
        .does(call -> call.answer(fingers(call).openingM()));
    TestBuiltins.declare(builtins, "finger_force", SECTION)
        .doc("How hard the fingers of a gripper press on a part; 0 where they hold none.")
        .needs("device", Type.STRING)
        .returns(Unit.NEWTON)
        .effect(Effect.SENSES)
        .does(call -> call.answer(fingers(call).pressN()));
  }

  private static Outcome add(Call<ControlBox> call) throws ScriptError {
    DeviceSetup device =
        DeviceSetup.of(call.text(0))
            .orElseThrow(
                () -> call.refuse(0, "must be one of " + String.join(", ", DeviceSetup.KINDS)));
    try {
      call.host().links().devices().add(device);
    } catch (IllegalArgumentException e) {
      throw call.failure(NO_DEVICE, e.getMessage());
    }
    return call.answer();
  }

  private static Fingers fingers(Call<ControlBox> call) throws ScriptError {
    String name = call.text(0);
    return call.host()
        .links()
        .devices()
        .fingers(name)
        .orElseThrow(() -> call.failure(NO_DEVICE, "there is no gripper " + name + " in the cell"));
  }
}
