package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.force.ForceAxis;
import org.pendant.motion.force.ForceTask;
import org.pendant.motion.force.FrameKind;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;

/** Force builtins: pressing with a force (manual 15.8, 15.10, 15.12 to 15.17, 15.43). */
final class ForceBuiltins {
  private static final String MODULE = "motion";

  private static final double MAX_GAIN = 2;

  private ForceBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareForceMode(builtins);
    declareTuning(builtins);
    builtins
        .declare("screw_driving")
        .manual(MODULE, "15.43")
        .doc(
            "Lets the TCP give way along its z axis until the tool presses with force f there, so"
                + " that it follows a screw; no faster than v_limit.")
        .needs("f", Unit.NEWTON)
        .needs("v_limit", Unit.METRE_PER_SECOND)
        .does(ForceBuiltins::screwDriving);
    builtins
        .declare("end_screw_driving")
        .manual(MODULE, "15.10")
        .doc("Ends screw driving or force mode: the arm comes to rest where it is.")
        .does(ForceBuiltins::end);
  }

  private static void declareForceMode(Builtins<ControlBox> builtins) {
    builtins
        .declare("force_mode")
        .manual(MODULE, "15.12")
        .doc(
            "Lets the TCP give way along some axes of a frame until the tool presses with a wanted"
                + " wrench, while moves continue. selection_vector has a 1 for each axis that gives"
                + " way; limits are speeds along those, and along the others the farthest that the"
                + " arm may be pushed aside: beyond it is a protective stop (C153). type 1 points y"
                + " from the TCP at the frame's origin, 2 takes the frame as it is, 3 points x"
                + " along the motion.")
        .needs("task_frame", Type.POSE)
        .needs("selection_vector", Type.LIST)
        .needs("wrench", Type.LIST)
        .needs("type", Type.INT)
        .needs("limits", Type.LIST)
        .does(ForceBuiltins::forceMode);
    builtins
        .declare("end_force_mode")
        .manual(MODULE, "15.8")
        .doc("Ends force mode or screw driving: the arm comes to rest where it is.")
        .does(ForceBuiltins::end);
  }

  private static void declareTuning(Builtins<ControlBox> builtins) {
    builtins
        .declare("force_mode_set_damping")
        .manual(MODULE, "15.16")
        .doc(
            "Sets the share of its speed that the TCP loses in each frame in force mode, 0 to 1;"
                + " 0.005 when a program starts.")
        .needs("damping", Type.NUMBER)
        .does(
            call -> {
              call.host().modes().forceMode().setDamping(within(call, 1));
              return call.answer();
            });
    builtins
        .declare("force_mode_get_damping")
        .manual(MODULE, "15.14")
        .doc("The share of its speed that the TCP loses in each frame in force mode.")
        .returns(Type.NUMBER)
        .effect(Effect.ASKS)
        .does(call -> call.answer(call.host().modes().forceMode().damping()));
    builtins
        .declare("force_mode_set_gain_scaling")
        .manual(MODULE, "15.17")
        .doc(
            "Sets how strongly the TCP answers to forces in force mode, 0 to 2; 1 when a program"
                + " starts. Above 1 the arm may shake on hard surfaces.")
        .needs("scaling", Type.NUMBER)
        .does(
            call -> {
              call.host().modes().forceMode().setGainScaling(within(call, MAX_GAIN));
              return call.answer();
            });
    builtins
        .declare("force_mode_get_gain_scaling")
        .manual(MODULE, "15.15")
        .doc("How strongly the TCP answers to forces in force mode.")
        .returns(Type.NUMBER)
        .effect(Effect.ASKS)
        .does(call -> call.answer(call.host().modes().forceMode().gainScaling()));
  }

  private static double within(Call<ControlBox> call, double largest) throws ScriptError {
    double number = call.number(0);
    if (!(number >= 0 && number <= largest)) {
      throw call.refuse(0, text("zeroTo", Math.round(largest)));
    }
    return number;
  }

  private static Outcome forceMode(Call<ControlBox> call) throws ScriptError {
    Pose frame = MotionArguments.pose(call, 0);
    double[] selection = call.numbers(1, ForceTask.AXES);
    double[] wrench = call.numbers(2, ForceTask.AXES);
    FrameKind kind = kind(call);
    double[] limits = call.numbers(4, ForceTask.AXES);
    List<ForceAxis> axes = new ArrayList<>();
    for (int i = 0; i < ForceTask.AXES; i++) {
      if (selection[i] != 0 && selection[i] != 1) {
        throw call.refuse(1, text("selection"));
      }
      if (!Double.isFinite(wrench[i])) {
        throw call.refuse(2, text("finite"));
      }
      if (!(limits[i] >= 0)) {
        throw call.refuse(4, text("noneNegative"));
      }
      boolean compliant = selection[i] == 1;
      // a wrench along another axis has no effect
      axes.add(new ForceAxis(compliant, compliant ? wrench[i] : 0, limits[i]));
    }
    return start(call, new ForceTask(kind, frame, axes));
  }

  private static FrameKind kind(Call<ControlBox> call) throws ScriptError {
    return switch (call.integer(3, 1, 3)) {
      case 1 -> FrameKind.POINT;
      case 2 -> FrameKind.FIXED;
      default -> FrameKind.MOTION;
    };
  }

  private static Outcome screwDriving(Call<ControlBox> call) throws ScriptError {
    double forceN = call.number(0);
    if (!Double.isFinite(forceN)) {
      throw call.refuse(0, text("finite"));
    }
    return start(call, ForceTask.screwDriving(forceN, MotionArguments.positive(call, 1)));
  }

  private static Outcome start(Call<ControlBox> call, ForceTask task) throws ScriptError {
    ControlBox box = call.host();
    if (box.offsets().path().active()) {
      throw call.failure("path-offset", text("pathOffsetEnabled"));
    }
    return Planning.named(
        call,
        () -> {
          box.drive().requirePower();
          box.modes().forceMode().start(task, box.kinematics().targetTcpInBase());
          return call.answer();
        });
  }

  private static Outcome end(Call<ControlBox> call) {
    call.host().modes().forceMode().finish();
    return call.answer();
  }
}
