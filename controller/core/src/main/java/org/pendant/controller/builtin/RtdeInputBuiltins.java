package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.arm.ExternalForceSensor;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Published;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.dynamics.Payload;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Declaration;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StringValue;

/**
 * RTDE input builtins: which client watches an input, and forces that clients measure (manual 18.1,
 * 18.2, 18.41).
 */
final class RtdeInputBuiltins {
  private static final String MODULE = "interfaces";

  private static final double DEFAULT_WATCHDOG_HZ = 10;

  private RtdeInputBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    sensor(builtins, "enable_external_ft_sensor", "18.1")
        .doc(
            "Has force control use the force/torque sensor whose readings an RTDE client sends;"
                + " torques due to its position count with the opposite sign.")
        .deprecated("ft_rtde_input_enable")
        .does(call -> enable(call, -1));
    sensor(builtins, "ft_rtde_input_enable", "18.2")
        .doc(
            "Has force mode, screw driving and freedrive use the force/torque sensor whose readings"
                + " an RTDE client sends as external_force_torque, until the program ends. The"
                + " declared payload must include the sensor. Without another watchdog the program"
                + " pauses when readings come less often than at 10 Hz.")
        .does(call -> enable(call, 1));
    builtins
        .declare("rtde_set_watchdog")
        .manual(MODULE, "18.41")
        .doc(
            "Watches until the program ends that RTDE clients write an input often enough. action"
                + " is what happens otherwise: \"ignore\" writes to the log only, \"pause\" and"
                + " \"stop\" hold or end the program.")
        .needs("variable_name", Type.STRING)
        .needs("min_frequency", Unit.HERTZ)
        .takes("action", Type.STRING, new StringValue("pause"))
        .does(RtdeInputBuiltins::setWatchdog);
  }

  private static Declaration<ControlBox> sensor(
      Builtins<ControlBox> builtins, String name, String section) {
    return builtins
        .declare(name)
        .manual(MODULE, section)
        .needs("enable", Type.BOOL)
        .takes("sensor_mass", Unit.KILOGRAM, 0)
        .takes("sensor_measuring_offset", Type.LIST, NumberList.of(0, 0, 0))
        .takes("sensor_cog", Type.LIST, NumberList.of(0, 0, 0));
  }

  private static Outcome enable(Call<ControlBox> call, double offsetSign) throws ScriptError {
    double massKg = call.number(1);
    if (!(massKg >= 0 && massKg < Double.POSITIVE_INFINITY)) {
      throw call.refuse(1, text("finiteNotNegative"));
    }
    double[] offsetM = finite(call, 2);
    double[] cogM = finite(call, 3);
    ControlBox box = call.host();
    if (call.bool(0)) {
      box.flange()
          .useExternalForceSensor(
              new ExternalForceSensor.Attachment(
                  Payload.of(massKg, cogM[0], cogM[1], cogM[2]),
                  offsetSign * offsetM[0],
                  offsetSign * offsetM[1],
                  offsetSign * offsetM[2]));
      box.links()
          .inputWatchdogs()
          .setUnlessAny(
              Published.EXTERNAL_FORCE_TORQUE,
              DEFAULT_WATCHDOG_HZ,
              WatchdogAction.PAUSE,
              box.clock().timeS());
    } else {
      box.flange().useOwnForceSensor();
      box.links().inputWatchdogs().removeUnasked();
    }
    return call.answer();
  }

  private static double[] finite(Call<ControlBox> call, int index) throws ScriptError {
    double[] numbers = call.numbers(index, 3);
    for (double number : numbers) {
      if (!Double.isFinite(number)) {
        throw call.refuse(index, text("finite"));
      }
    }
    return numbers;
  }

  private static Outcome setWatchdog(Call<ControlBox> call) throws ScriptError {
    String input = call.text(0);
    if (!call.host().links().published().takesInput(input)) {
      throw call.refuse(0, text("rtdeInput"));
    }
    double leastHz = call.number(1);
    if (!(leastHz > 0 && leastHz < Double.POSITIVE_INFINITY)) {
      throw call.refuse(1, text("finitePositive"));
    }
    call.host()
        .links()
        .inputWatchdogs()
        .set(input, leastHz, action(call), call.host().clock().timeS());
    return call.answer();
  }

  private static WatchdogAction action(Call<ControlBox> call) throws ScriptError {
    return switch (call.word(2)) {
      case "ignore" -> WatchdogAction.IGNORE;
      case "pause" -> WatchdogAction.PAUSE;
      case "stop" -> WatchdogAction.STOP;
      default -> throw call.refuse(2, text("watchdogAction"));
    };
  }
}
