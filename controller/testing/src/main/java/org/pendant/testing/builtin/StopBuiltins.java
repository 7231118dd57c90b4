package org.pendant.testing.builtin;

import java.util.Locale;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;

/** Safety events: what people and machines around the arm do to its safety functions. */
final class StopBuiltins {
  private static final String SECTION = "Safety";

  private StopBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    input(builtins, "press_emergency_stop", SafetyInput.EMERGENCY_STOP, true)
        .doc("Presses the emergency stop button of the robot.");
    input(builtins, "release_emergency_stop", SafetyInput.EMERGENCY_STOP, false)
        .doc("Releases the emergency stop button; the arm stays without power.");
    input(builtins, "open_safeguard", SafetyInput.SAFEGUARD_STOP, true)
        .doc("Demands a safeguard stop, as a door that opens does.");
    input(builtins, "close_safeguard", SafetyInput.SAFEGUARD_STOP, false)
        .doc("Ends what open_safeguard demands; the program continues by itself.");
    TestBuiltins.declare(builtins, "set_reduced_mode", SECTION)
        .doc("Demands the reduced limits, or no longer does.")
        .needs("active", Type.BOOL)
        .does(
            call -> {
              call.host().safety().setInput(SafetyInput.REDUCED_MODE, call.bool(0));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "unlock_protective_stop", SECTION)
        .doc("Ends a protective stop; the program stays paused until resume_program().")
        .does(
            call -> {
              TestBuiltins.bench(call).post(new SafetyCommand.UnlockProtectiveStop(true));
              return call.answer();
            });
    TestBuiltins.declare(builtins, "expect_safety_stop", SECTION)
        .doc("Says that the test wants the safety functions to stop the arm, which fails it else.")
        .does(
            call -> {
              TestBuiltins.bench(call).expected().safetyStop();
              return call.answer();
            });
    TestBuiltins.declare(builtins, "safety_mode", SECTION)
        .doc("The safety mode in small letters, such as \"normal\" or \"protective_stop\".")
        .returns(Type.STRING)
        .effect(Effect.SENSES)
        .does(
            call -> call.answer(call.host().safety().safetyMode().name().toLowerCase(Locale.ROOT)));
    TestBuiltins.declare(builtins, "safety_message", SECTION)
        .doc("Why the safety functions have stopped the arm; an empty string where they have not.")
        .returns(Type.STRING)
        .effect(Effect.SENSES)
        .does(call -> call.answer(call.host().safety().stop().map(SafetyStop::message).orElse("")));
  }

  /** A function that demands something of the safety functions, and says so. */
  private static Documented input(
      Builtins<ControlBox> builtins, String name, SafetyInput input, boolean active) {
    return text ->
        TestBuiltins.declare(builtins, name, SECTION)
            .doc(text)
            .does(call -> set(call, input, active));
  }

  /** The rest of a declaration. */
  private interface Documented {
    void doc(String text);
  }

  private static Outcome set(Call<ControlBox> call, SafetyInput input, boolean active) {
    TestBuiltins.bench(call).expected().safetyStop();
    call.host().safety().setInput(input, active);
    return call.answer();
  }
}
