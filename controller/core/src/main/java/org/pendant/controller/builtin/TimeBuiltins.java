package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.time.FrameTime;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.function.Wait;
import org.pendant.script.value.NoneValue;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.StructValue;
import org.pendant.script.value.Value;

/** Time builtins: waiting and clocks (manual 16.22, 16.54, 16.55, 16.62). */
final class TimeBuiltins {
  private static final String MODULE = "internals";
  private static final Optional<Value> DONE = Optional.of(NoneValue.NONE);
  private static final List<String> TIME_MEMBERS = List.of("sec", "nanosec");
  private static final long NS_PER_S = 1_000_000_000L;

  private TimeBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_steptime")
        .manual(MODULE, "16.22")
        .doc("The length of a frame, in s.")
        .returns(Unit.SECOND)
        .does(call -> call.answer(FrameTime.FRAME_S));
    builtins
        .declare("sleep")
        .manual(MODULE, "16.54")
        .doc(
            "Pauses this script thread; other threads and motions continue. Takes a frame at"
                + " least.")
        .needs("t", Unit.SECOND)
        .physicalTime()
        .does(TimeBuiltins::sleep);
    builtins
        .declare("sync")
        .manual(MODULE, "16.62")
        .doc("Waits for the next frame.")
        .physicalTime()
        .does(call -> until(call.frame() + 1));
    builtins
        .declare("time")
        .manual(MODULE, "16.55")
        .doc(
            "A time as struct(sec, nanosec): with mode 0 since the controller started, with mode 2"
                + " the date and time in UTC, since 1970.")
        .takes("mode", Type.INT, Value.of(0))
        .returns(Type.STRUCT)
        .effect(Effect.SENSES)
        .does(TimeBuiltins::time);
  }

  private static Outcome sleep(Call<ControlBox> call) throws ScriptError {
    double durationS = MotionArguments.notNegative(call, 0);
    return until(call.frame() + FrameTime.framesFor(durationS));
  }

  private static Wait until(long wakeFrame) {
    return frame -> frame >= wakeFrame ? DONE : Optional.empty();
  }

  private static Outcome time(Call<ControlBox> call) throws ScriptError {
    return switch (call.integer(0)) {
      case 0 -> {
        long ns = call.host().clock().timeNs();
        yield call.answer(struct(ns / NS_PER_S, (int) (ns % NS_PER_S)));
      }
      case 2 -> {
        Instant now = call.host().clock().systemTime();
        yield call.answer(struct(now.getEpochSecond(), now.getNano()));
      }
      default -> throw call.refuse(0, text("clock"));
    };
  }

  private static StructValue struct(long seconds, int nanoseconds) {
    return StructValue.owning(TIME_MEMBERS, Value.of((int) seconds), Value.of(nanoseconds));
  }
}
