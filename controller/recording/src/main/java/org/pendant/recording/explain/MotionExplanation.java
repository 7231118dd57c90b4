package org.pendant.recording.explain;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SpeedUse;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.vm.ProgramState;

/**
 * Motion explanation: what was planned and what happened in one frame, and what set the speed of
 * the arm then.
 *
 * @param now the frame
 * @param text of the line of the program; empty without one
 * @param plannedSpeedMPerS of the tool
 * @param actualSpeedMPerS of the tool
 * @param plannedAccelerationMPerS2 by how much the speed of the tool along its way changes
 * @param uses how much of the limits that slow motions down is used, the nearest to its limit first
 */
public record MotionExplanation(
    ControllerState now,
    String text,
    double plannedSpeedMPerS,
    double actualSpeedMPerS,
    double plannedAccelerationMPerS2,
    List<SpeedUse> uses,
    Cause cause) {
  /** From this share of a limit on it is taken for met: rounding and the next frame. */
  private static final double MET = 0.995;

  /** What is the same speed, as a share. */
  private static final double SAME = 2e-3;

  /** What is no change from a frame to the next, as a share. */
  private static final double STEADY = SAME / 10;

  private static final double START_RAMP_S = 0.160;

  /** Copies the list. */
  public MotionExplanation {
    uses = List.copyOf(uses);
  }

  /** How far the tool is from where it should be, m. */
  public double followingErrorM() {
    var planned = now.geometry().targetTcpInBase();
    var actual = now.geometry().actualTcpInBase();
    double x = planned.x() - actual.x();
    double y = planned.y() - actual.y();
    double z = planned.z() - actual.z();
    return Math.sqrt(x * x + y * y + z * z);
  }

  /**
   * Explains a frame.
   *
   * @param frame of the recording
   * @param safety limits that held
   * @param startRamp whether programs begin with a start ramp
   */
  public static MotionExplanation of(
      Recording recording, long frame, SafetyConfiguration safety, boolean startRamp) {
    ControllerState now = recording.atFrame(frame);
    ControllerState before = recording.atFrame(now.frame() - 1);
    Optional<RecordedProgram> program = recording.programAt(now.timeS());
    String text = program.map(each -> line(each, now.program().line())).orElse("");
    long started = program.map(RecordedProgram::frame).orElse(Long.MIN_VALUE);
    double sinceStartS = (now.frame() - started) * FrameTime.FRAME_S;
    boolean ramp = startRamp && started >= 0 && sinceStartS < START_RAMP_S;
    ArmState arm = now.arm();
    List<SpeedUse> uses =
        SpeedUse.of(
            arm.description(),
            arm.targetPositionRad(),
            arm.targetSpeedRadPerS(),
            arm.tool().inFlange(),
            now.readings().momentumKgMPerS(),
            now.safety().reduced() ? safety.reduced() : safety.normal());
    double planned = toolSpeed(now);
    double plannedBefore = toolSpeed(before);
    Optional<MoveCall> call = MoveCall.of(text, name -> variable(now, name));
    return new MotionExplanation(
        now,
        text.strip(),
        planned,
        length(
            now.geometry().actual().speed().x(),
            now.geometry().actual().speed().y(),
            now.geometry().actual().speed().z()),
        (planned - plannedBefore) / FrameTime.FRAME_S,
        uses,
        cause(new Around(before, now, recording.atFrame(now.frame() + 1)), uses, text, call, ramp));
  }

  /** A frame, the one before and the one after. */
  private record Around(ControllerState before, ControllerState now, ControllerState after) {}

  private static String line(RecordedProgram program, int line) {
    return program
        .source()
        .text()
        .lines()
        .skip(Math.max(0, line - 1))
        .findFirst()
        .filter(text -> line > 0)
        .map(ByteText::decoded)
        .orElse("");
  }

  private static OptionalDouble variable(ControllerState state, String name) {
    return state
        .variables()
        .find(VariablePath.of(name))
        .flatMap(VariableSample::value)
        .map(MotionExplanation::number)
        .orElseGet(OptionalDouble::empty);
  }

  private static OptionalDouble number(Value value) {
    if (value instanceof FloatValue(double number)) {
      return OptionalDouble.of(number);
    }
    return value instanceof IntValue(int whole) ? OptionalDouble.of(whole) : OptionalDouble.empty();
  }

  private static double toolSpeed(ControllerState state) {
    var speed = state.geometry().target().speed();
    return length(speed.x(), speed.y(), speed.z());
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }

  // --- what set the speed

  private static Cause cause(
      Around frames, List<SpeedUse> uses, String text, Optional<MoveCall> call, boolean startRamp) {
    ArmState arm = frames.now().arm();
    if (frames.now().freedrive().active()) {
      return Cause.certain(Cause.Kind.HAND);
    }
    if (arm.targetSpeedRadPerS().equals(Joints.ZERO)
        && frames.before().arm().targetSpeedRadPerS().equals(Joints.ZERO)) {
      return Cause.certain(Cause.Kind.REST);
    }
    return switch (arm.controlMode()) {
      case TORQUE -> Cause.certain(Cause.Kind.TORQUE);
      default -> moving(frames, uses, text, call, startRamp);
    };
  }

  private static Cause moving(
      Around frames, List<SpeedUse> uses, String text, Optional<MoveCall> call, boolean startRamp) {
    ControllerState now = frames.now();
    if (now.safety().stop().isPresent()) {
      return Cause.certain(Cause.Kind.SAFETY_STOP);
    }
    if (now.program().state() == ProgramState.PAUSED) {
      return Cause.certain(Cause.Kind.PAUSE);
    }
    if (startRamp) {
      return Cause.certain(Cause.Kind.START_RAMP);
    }
    double scaling = now.arm().speedScaling();
    boolean less = scaling < now.arm().speedFraction() - 1e-9;
    SpeedUse nearest = uses.getFirst();
    if (less && nearest.share() >= MET) {
      return Cause.met(Cause.Kind.SAFETY_LIMIT, nearest);
    }
    if (Math.abs(scaling - frames.before().arm().speedScaling()) > 1e-9) {
      return Cause.certain(Cause.Kind.SCALING_RAMP);
    }
    if (less) {
      return Cause.of(Cause.Kind.SCALING, false, scaling);
    }
    if (call.isEmpty() && MoveCall.streams(text)) {
      return Cause.certain(Cause.Kind.STREAMED);
    }
    return planned(frames, nearest, call, scaling);
  }

  /** Nothing but its plan sets the speed, at a scaling that does not change. */
  private static Cause planned(
      Around frames, SpeedUse nearest, Optional<MoveCall> call, double scaling) {
    boolean joints = call.map(MoveCall::ofJoints).orElse(false);
    double speed = speed(frames.now(), joints);
    double last = speed(frames.before(), joints);
    double own = speed / scaling;
    double rate = (speed - last) / FrameTime.FRAME_S / (scaling * scaling);
    OptionalDouble asked = call.map(MoveCall::speed).orElseGet(OptionalDouble::empty);
    boolean slower = asked.isPresent() && own < asked.getAsDouble() * (1 - SAME);
    double next = speed(frames.after(), joints);
    if (slower && last < speed * (1 - STEADY) && next < speed * (1 - STEADY)) {
      return Cause.of(Cause.Kind.SHORT_WAY, true, own).asking(asked.getAsDouble());
    }
    if (Math.abs(speed - last) / Math.max(speed, last) > STEADY) {
      // that it does is in the frames, whatever sets the rate
      return Cause.of(
              rate > 0 ? Cause.Kind.ACCELERATION : Cause.Kind.DECELERATION, true, Math.abs(rate))
          .asking(
              call.map(MoveCall::acceleration).orElseGet(OptionalDouble::empty).orElse(Double.NaN));
    }
    if (slower) {
      return nearest.kind() == SpeedUse.Kind.JOINT_SPEED && nearest.share() >= MET
          ? Cause.met(Cause.Kind.JOINT_LIMIT, nearest).asking(asked.getAsDouble())
          : Cause.of(Cause.Kind.PATH_LIMIT, false, own).asking(asked.getAsDouble());
    }
    if (call.map(MoveCall::timed).orElse(false)) {
      return Cause.of(Cause.Kind.COMMAND_TIME, true, own);
    }
    boolean certain = asked.isPresent() && same(own, asked.getAsDouble());
    return Cause.of(Cause.Kind.COMMAND_SPEED, certain, own);
  }

  private static double speed(ControllerState state, boolean joints) {
    return joints ? fastest(state) : toolSpeed(state);
  }

  /** Whether a number is what the line asks for. */
  static boolean same(double value, double asked) {
    return Math.abs(value - asked) <= SAME * asked;
  }

  private static double fastest(ControllerState state) {
    double fastest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      fastest = Math.max(fastest, Math.abs(state.arm().targetSpeedRadPerS().get(i)));
    }
    return fastest;
  }
}
