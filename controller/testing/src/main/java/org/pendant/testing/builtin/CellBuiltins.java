package org.pendant.testing.builtin;

import static org.pendant.testing.builtin.TestTexts.text;

import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.device.DeviceSetup;
import org.pendant.controller.device.gripper.Fingers;
import org.pendant.controller.world.MovedObject;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.PoseValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Devices of the cell that answer programs, and the parts in their fingers. */
final class CellBuiltins {
  private static final String SECTION = "Devices of the cell";
  private static final String NO_DEVICE = "no-such-device";
  private static final String NO_SIGNAL = "no-such-signal";

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
    TestBuiltins.declare(builtins, "press_button", SECTION)
        .doc("Presses a button or a limit switch by hand; False lets go of it.")
        .needs("device", Type.STRING)
        .takes("pressed", Type.BOOL, Value.of(true))
        .does(
            call -> {
              try {
                call.host().links().devices().press(call.text(0), call.bool(1));
              } catch (IllegalArgumentException e) {
                throw call.failure(NO_DEVICE, e.getMessage());
              }
              return call.answer();
            });
    declareSignalsIn(builtins);
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
    declareObjectsIn(builtins);
  }

  private static void declareSignalsIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "cell_signal", SECTION)
        .doc(
            "The value of a signal of the cell, such as \"plc.register[3]\" or \"digital_out[0]\";"
                + " 0 or 1 where it is digital.")
        .needs("signal", Type.STRING)
        .returns(Type.INT)
        .effect(Effect.SENSES)
        .does(
            call -> {
              try {
                return call.answer(call.host().links().devices().value(call.text(0)));
              } catch (IllegalArgumentException e) {
                throw call.failure(NO_SIGNAL, e.getMessage());
              }
            });
    TestBuiltins.declare(builtins, "set_cell_signal", SECTION)
        .doc(
            "Sets a signal of the cell, such as \"plc.register[3]\" or \"digital_in[0]\": to an"
                + " int, or a bool where it is digital.")
        .needs("signal", Type.STRING)
        .needs("value", Type.ANY)
        .does(
            call -> {
              int value =
                  call.kind(1) == ValueKind.BOOL
                      ? call.bool(1) ? 1 : 0
                      : call.integer(1, Integer.MIN_VALUE, Integer.MAX_VALUE);
              try {
                call.host().links().devices().set(call.text(0), value);
              } catch (IllegalArgumentException e) {
                throw call.failure(NO_SIGNAL, e.getMessage());
              }
              return call.answer();
            });
  }

  private static void declareObjectsIn(Builtins<ControlBox> builtins) {
    TestBuiltins.declare(builtins, "object_pose", SECTION)
        .doc(
            "Where the middle of an object of the scene that has a mass is now, and how it is"
                + " turned, in the base; of a mesh, where the origin of its file is. Copies that"
                + " a source has made are called as in \"box #2\".")
        .needs("name", Type.STRING)
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(
            call -> {
              String name = call.text(0);
              Optional<MovedObject> object = there(call);
              if (object.isEmpty()) {
                throw call.failure("no-such-object", text("noObject", name));
              }
              return call.answer(new PoseValue(object.get().poseInBase()));
            });
    TestBuiltins.declare(builtins, "object_there", SECTION)
        .doc(
            "Whether an object of the scene that has a mass is in the cell now: a copy that a"
                + " source has not made yet is not, nor is one that a sink has taken.")
        .needs("name", Type.STRING)
        .returns(Type.BOOL)
        .effect(Effect.SENSES)
        .does(call -> call.answer(there(call).isPresent()));
  }

  private static Optional<MovedObject> there(Call<ControlBox> call) throws ScriptError {
    String name = call.text(0);
    return call.host().arm().world().moved().stream()
        .filter(each -> each.there() && each.name().equals(name))
        .findFirst();
  }

  private static Outcome add(Call<ControlBox> call) throws ScriptError {
    DeviceSetup device =
        DeviceSetup.of(call.text(0))
            .orElseThrow(() -> call.refuse(0, text("oneOf", String.join(", ", DeviceSetup.KINDS))));
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
        .orElseThrow(() -> call.failure(NO_DEVICE, text("noGripper", name)));
  }
}
