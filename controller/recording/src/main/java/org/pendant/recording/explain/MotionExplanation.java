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
        cause(before, now, uses, call, ramp));
  }

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
      ControllerState before,
      ControllerState now,
      List<SpeedUse> uses,
      Optional<MoveCall> call,
      boolean startRamp) {
    ArmState arm = now.arm();
    if (now.freedrive().active()) {
      return Cause.certain(Cause.Kind.HAND);
    }
    if (arm.targetSpeedRadPerS().equals(Joints.ZERO)
        && before.arm().targetSpeedRadPerS().equals(Joints.ZERO)) {
      return Cause.certain(Cause.Kind.REST);
    }
    return switch (arm.controlMode()) {
      case TORQUE -> Cause.certain(Cause.Kind.TORQUE);
      default -> moving(before, now, uses, call, startRamp);
    };
  }

  private static Cause moving(
      ControllerState before,
      ControllerState now,
      List<SpeedUse> uses,
      Optional<MoveCall> call,
      boolean startRamp) {
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
    double wanted = now.arm().speedFraction();
    boolean less = scaling < wanted - 1e-9;
    SpeedUse nearest = uses.getFirst();
    if (nearest.share() >= MET) {
      return new Cause(Cause.Kind.SAFETY_LIMIT, less, nearest.value(), Optional.of(nearest));
    }
    if (Math.abs(scaling - before.arm().speedScaling()) > 1e-9) {
      return Cause.certain(Cause.Kind.SCALING_RAMP);
    }
    if (less) {
      return Cause.of(Cause.Kind.SCALING, false, scaling);
    }
    return planned(before, now, call, scaling);
  }

  /** Nothing but its plan sets the speed, at a scaling that does not change. */
  private static Cause planned(
      ControllerState before, ControllerState now, Optional<MoveCall> call, double scaling) {
    boolean joints = call.map(MoveCall::ofJoints).orElse(false);
    double speed = joints ? fastest(now) : toolSpeed(now);
    double last = joints ? fastest(before) : toolSpeed(before);
    double own = speed / scaling;
    double rate = (speed - last) / FrameTime.FRAME_S / (scaling * scaling);
    double perFrame = Math.abs(speed - last) / Math.max(speed, last);
    if (perFrame > SAME / 10) {
      OptionalDouble asked = call.map(MoveCall::acceleration).orElseGet(OptionalDouble::empty);
      boolean certain = asked.isPresent() && same(Math.abs(rate), asked.getAsDouble());
      return Cause.of(
          rate > 0 ? Cause.Kind.ACCELERATION : Cause.Kind.DECELERATION, certain, Math.abs(rate));
    }
    OptionalDouble asked = call.map(MoveCall::speed).orElseGet(OptionalDouble::empty);
    if (asked.isPresent() && own < asked.getAsDouble() * (1 - SAME)) {
      return Cause.of(Cause.Kind.PATH_LIMIT, false, asked.getAsDouble());
    }
    boolean certain = asked.isPresent() && same(own, asked.getAsDouble());
    return Cause.of(Cause.Kind.COMMAND_SPEED, certain, own);
  }

  private static boolean same(double value, double asked) {
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
