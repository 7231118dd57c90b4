package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.force.ContactWatch;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.ValueKind;

/** Contact builtins: noticing that the tool has met something (manual 16.66). */
final class ContactBuiltins {
  private ContactBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    builtins
        .declare("tool_contact")
        .manual("internals", "16.66")
        .doc(
            "How many frames ago the tool was just not in contact yet, 0 if it touches nothing;"
                + " get_actual_joint_positions_history says where the arm was then. direction is"
                + " where the tool goes, along the axes of the base: only what pushes back against"
                + " it counts. force_threshold is the change of force that is a contact, 5 N if it"
                + " is 0.")
        .takes("direction", Type.POSE_OR_JOINTS, NumberList.of(0, 0, 0, 0, 0, 0))
        .takes("force_threshold", Unit.NEWTON, 0)
        .returns(Type.INT)
        .does(ContactBuiltins::toolContact);
  }

  private static Outcome toolContact(Call<ControlBox> call) throws ScriptError {
    double[] direction = direction(call);
    double threshold = MotionArguments.notNegative(call, 1);
    return call.answerInt(
        call.host()
            .flange()
            .contactWatch()
            .framesSinceOnset(direction, threshold > 0 ? threshold : ContactWatch.THRESHOLD_N));
  }

  /** A list of six numbers, or a pose as get_target_tcp_speed gives it. */
  private static double[] direction(Call<ControlBox> call) throws ScriptError {
    double[] direction;
    if (call.kind(0) == ValueKind.POSE) {
      Pose pose = call.pose(0);
      direction = new double[] {pose.x(), pose.y(), pose.z()};
    } else {
      direction = call.numbers(0, Pose.SIZE);
    }
    for (int i = 0; i < 3; i++) {
      if (!Double.isFinite(direction[i])) {
        throw call.refuse(0, text("finite"));
      }
    }
    return direction;
  }
}
