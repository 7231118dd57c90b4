package org.pendant.controller.builtin;

import static org.pendant.controller.builtin.BuiltinTexts.text;

import org.pendant.controller.box.ControlBox;
import org.pendant.controller.encoder.Encoder;
import org.pendant.language.signature.Type;
import org.pendant.language.signature.Unit;
import org.pendant.models.pose.Pose;
import org.pendant.motion.MotionControl;
import org.pendant.motion.StopJ;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Call;
import org.pendant.script.function.Effect;
import org.pendant.script.function.Outcome;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;

/** Conveyor builtins: moving along with conveyors (manual 15.22, 15.23, 15.50, 15.56, 15.57). */
final class ConveyorBuiltins {
  private static final String MODULE = "motion";

  private ConveyorBuiltins() {}

  static void declareIn(Builtins<ControlBox> builtins) {
    declareTracking(builtins);
    declareAlongPath(builtins);
  }

  private static void declareTracking(Builtins<ControlBox> builtins) {
    builtins
        .declare("track_conveyor_linear")
        .manual(MODULE, "15.57")
        .doc(
            "Carries the tool along with a straight conveyor, besides all moves, from where the"
                + " belt is now. direction is a pose of which x, y and z count, in the base frame.")
        .needs("direction", Type.POSE)
        .needs("ticks_per_meter", Type.NUMBER)
        .takes("encoder_index", Type.INT, Value.of(0))
        .does(ConveyorBuiltins::trackLinear);
    builtins
        .declare("track_conveyor_circular")
        .manual(MODULE, "15.56")
        .doc(
            "Carries the tool along with a conveyor that turns about the z axis of center, besides"
                + " all moves, from where the belt is now; rotate_tool turns the tool with it.")
        .needs("center", Type.POSE)
        .needs("ticks_per_revolution", Type.NUMBER)
        .takes("rotate_tool", Type.BOOL, Value.of(false))
        .takes("encoder_index", Type.INT, Value.of(0))
        .does(ConveyorBuiltins::trackCircular);
    builtins
        .declare("stop_conveyor_tracking")
        .manual(MODULE, "15.50")
        .doc(
            "Ends conveyor tracking, slows all joints down in proportion and waits until they"
                + " rest.")
        .takes("a", Unit.RADIAN_PER_SECOND_SQUARED, 20)
        .physicalTime()
        .does(ConveyorBuiltins::stop);
  }

  private static void declareAlongPath(Builtins<ControlBox> builtins) {
    builtins
        .declare("get_target_tcp_pose_along_path")
        .manual(MODULE, "15.22")
        .doc(
            "Where the TCP should be in the base frame, were there no conveyor, path offset or"
                + " force mode.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(ConveyorBuiltins::poseAlongPath);
    builtins
        .declare("get_target_tcp_speed_along_path")
        .manual(MODULE, "15.23")
        .doc(
            "How fast the TCP should move, were there no conveyor, path offset or force mode, in"
                + " m/s and rad/s along the axes of the base frame.")
        .returns(Type.POSE)
        .effect(Effect.SENSES)
        .does(ConveyorBuiltins::speedAlongPath);
  }

  private static Outcome trackLinear(Call<ControlBox> call) throws ScriptError {
    Pose direction = MotionArguments.pose(call, 0);
    if (direction.x() == 0 && direction.y() == 0 && direction.z() == 0) {
      throw call.refuse(0, text("directionOfBelt"));
    }
    double ticksPerM = ticks(call, 1);
    Encoder encoder = ready(call, 2);
    call.host().offsets().conveyor().trackLinear(direction, ticksPerM, encoder);
    return call.answer();
  }

  private static Outcome trackCircular(Call<ControlBox> call) throws ScriptError {
    Pose center = MotionArguments.pose(call, 0);
    double ticksPerRevolution = ticks(call, 1);
    boolean rotateTool = call.bool(2);
    Encoder encoder = ready(call, 3);
    call.host().offsets().conveyor().trackCircular(center, ticksPerRevolution, rotateTool, encoder);
    return call.answer();
  }

  private static double ticks(Call<ControlBox> call, int index) throws ScriptError {
    double ticks = call.number(index);
    if (ticks == 0 || !Double.isFinite(ticks)) {
      throw call.refuse(index, text("finiteNotZero"));
    }
    return ticks;
  }

  /** The encoder that argument {@code index} names, if a conveyor may be tracked by it now. */
  private static Encoder ready(Call<ControlBox> call, int index) throws ScriptError {
    Encoder encoder = EncoderBuiltins.encoder(call, index);
    ControlBox box = call.host();
    if (box.offsets().conveyor().active()) {
      throw call.failure("conveyor-tracked", text("conveyorTracked"));
    }
    if (box.offsets().path().active()) {
      throw call.failure("path-offset", text("pathOffsetEnabled"));
    }
    if (box.motion().guided()) {
      throw call.failure("freedrive", text("inFreedrive"));
    }
    if (!encoder.enabled()) {
      box.log().warning(text("beltStands", call.integer(index)));
    }
    return encoder;
  }

  private static Outcome stop(Call<ControlBox> call) throws ScriptError {
    double deceleration = MotionArguments.positive(call, 0);
    MotionControl motion = call.host().motion();
    Planning.act(call, () -> motion.endOffset(call.host().offsets().conveyor()));
    return MotionWait.stop(
        call, "stop_conveyor_tracking", (from, speed) -> new StopJ(from, speed, deceleration));
  }

  private static Outcome poseAlongPath(Call<ControlBox> call) {
    ControlBox box = call.host();
    return call.answer(
        box.kinematics()
            .forward()
            .tcpPose(box.motion().pathPositionRad(), box.flange().tool().inFlange()));
  }

  private static Outcome speedAlongPath(Call<ControlBox> call) {
    MotionControl motion = call.host().motion();
    return call.answer(
        call.host()
            .kinematics()
            .tcpTwistInBase(motion.pathPositionRad(), motion.pathSpeedRadPerS()));
  }
}
