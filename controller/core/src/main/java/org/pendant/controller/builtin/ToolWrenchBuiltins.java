package org.pendant.controller.builtin;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.ToolWrenchLimit;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/**
 * Tool wrench builtins: limits of what motion does to the object that the tool holds (manual 15.53,
 * 15.54).
 */
final class ToolWrenchBuiltins {
  private static final String MODULE = "motion";
  private static final String UNLIMITED = "not limited";

  private ToolWrenchBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("tool_wrench_limit_set")
        .manual(MODULE, "15.53")
        .doc(
            "Slows moves down so that accelerating the payload takes no more than these forces and"
                + " moments in a frame at the flange. Axes that are left out are not limited. It"
                + " holds until the controller is switched off.")
        .needs("frame_offset", Type.POSE)
        .mayTake("Fx", Type.NUMBER, Unit.NEWTON, UNLIMITED)
        .mayTake("Fy", Type.NUMBER, Unit.NEWTON, UNLIMITED)
        .mayTake("Fz", Type.NUMBER, Unit.NEWTON, UNLIMITED)
        .mayTake("Mx", Type.NUMBER, Unit.NEWTON_METRE, UNLIMITED)
        .mayTake("My", Type.NUMBER, Unit.NEWTON_METRE, UNLIMITED)
        .mayTake("Mz", Type.NUMBER, Unit.NEWTON_METRE, UNLIMITED)
        .does(ToolWrenchBuiltins::set);
    builtins
        .declare("tool_wrench_limit_disable")
        .manual(MODULE, "15.54")
        .doc("Ends the limits that tool_wrench_limit_set has put on moves.")
        .does(ToolWrenchBuiltins::disable);
  }

  private static Outcome set(Call<ControlBox> call) throws ScriptError {
    Pose frame = MotionArguments.pose(call, 0);
    List<Double> limits = new ArrayList<>();
    for (int i = 1; i <= Pose.SIZE; i++) {
      limits.add(call.given(i) ? MotionArguments.positive(call, i) : Double.POSITIVE_INFINITY);
    }
    call.host()
        .planning()
        .limits()
        .setToolWrenchLimit(Optional.of(new ToolWrenchLimit(frame, limits)));
    return call.answer();
  }

  private static Outcome disable(Call<ControlBox> call) {
    call.host().planning().limits().setToolWrenchLimit(Optional.empty());
    return call.answer();
  }
}
