package org.pendant.sweep.run;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.Singularity;
import org.pendant.models.pose.Wrench;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.lines.FrameMargins;
import org.pendant.recording.lines.Margin;

/** Run measure: what a run takes, frame by frame. Mutable, for one run. */
final class RunMeasure {
  private static final long FACTOR = 0x9E3779B97F4A7C15L;
  private static final int MAX_OUTPUTS = 64;
  private static final List<Singularity> SINGULARITIES = List.of(Singularity.values());
  private static final List<SignalBank> OUTPUTS =
      List.of(SignalBank.STANDARD_OUT, SignalBank.CONFIGURABLE_OUT, SignalBank.TOOL_OUT);

  private final FrameMargins margins;
  private final DhLengths lengths;
  private final ControllerState start;
  private final JointSums torque;
  private final JointSums speed;
  private final JointSums current;
  private final List<OutputChange> outputs = new ArrayList<>();
  private final double[] q = new double[Joints.COUNT];
  private ControllerState newest;
  private long[] lineFrames = new long[64];
  private double jointLimitRad = Double.POSITIVE_INFINITY;
  private double planeM = Double.POSITIVE_INFINITY;
  private double singularity = Double.POSITIVE_INFINITY;
  private double toolSpeedMPerS;
  private double toolSpeedShare;
  private double forceN;
  private double torqueNm;
  private long digest;
  private int line;

  RunMeasure(ControllerState start, SafetyConfiguration safety) {
    this.start = start;
    newest = start;
    ArmDescription arm = start.arm().description();
    lengths = arm.dh();
    margins = new FrameMargins(start.arm(), safety);
    double[] mostTorque = new double[Joints.COUNT];
    double[] mostSpeed = new double[Joints.COUNT];
    double[] none = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      mostTorque[i] = arm.joints().get(i).maxTorqueNm();
      mostSpeed[i] = arm.joints().get(i).maxSpeedRadPerS();
    }
    Arrays.fill(none, Double.NaN);
    torque = new JointSums(mostTorque);
    speed = new JointSums(mostSpeed);
    current = new JointSums(none);
  }

  /** A frame has ended. */
  void see(ControllerState state) {
    Joints before = newest.arm().targetPositionRad();
    margins.look(state);
    torque.add(state.readings().torqueNm());
    speed.add(state.arm().actualSpeedRadPerS());
    current.add(state.readings().currentA());
    jointLimitRad = Math.min(jointLimitRad, margins.value(Margin.JOINT_LIMIT));
    planeM = Math.min(planeM, margins.value(Margin.PLANE));
    toolSpeedShare = Math.max(toolSpeedShare, margins.value(Margin.TOOL_SPEED));
    toolSpeedMPerS = Math.max(toolSpeedMPerS, margins.toolSpeedMPerS());
    if (!state.arm().targetPositionRad().equals(before) || Double.isInfinite(singularity)) {
      lookAtSingularities(state.arm().targetPositionRad());
    }
    Wrench outside = state.readings().flangeWrenchInBase();
    forceN = Math.max(forceN, length(outside.fx(), outside.fy(), outside.fz()));
    torqueNm = Math.max(torqueNm, length(outside.mx(), outside.my(), outside.mz()));
    int now = state.program().line();
    if (now > 0) {
      line = now;
      if (now >= lineFrames.length) {
        lineFrames = Arrays.copyOf(lineFrames, Math.max(now + 1, 2 * lineFrames.length));
      }
      lineFrames[now]++;
    }
    if (!state.io().equals(newest.io())) {
      noteOutputs(newest.io(), state.io(), timeS(state));
    }
    digest = digest(state);
    newest = state;
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }

  private void lookAtSingularities(Joints positionRad) {
    positionRad.copyTo(q);
    for (int i = 0; i < SINGULARITIES.size(); i++) {
      singularity = Math.min(singularity, SINGULARITIES.get(i).measure(lengths, q));
    }
  }

  private void noteOutputs(DigitalLevels before, DigitalLevels now, double timeS) {
    for (SignalBank bank : OUTPUTS) {
      int changed = before.bits(bank) ^ now.bits(bank);
      for (int i = 0; changed >>> i != 0; i++) {
        if ((changed >>> i & 1) != 0 && outputs.size() < MAX_OUTPUTS) {
          outputs.add(
              new OutputChange(
                  bank.text() + "[" + i + "]", (now.bits(bank) >>> i & 1) != 0, timeS));
        }
      }
    }
  }

  private long digest(ControllerState state) {
    long mixed = mix(digest, state.frame());
    mixed = mix(mixed, state.program().line());
    mixed = mix(mixed, state.io().hashCode());
    mixed = mix(mixed, state.arm().targetPositionRad());
    mixed = mix(mixed, state.arm().actualPositionRad());
    return mix(mixed, state.readings().currentA());
  }

  private static long mix(long mixed, Joints joints) {
    long result = mixed;
    for (int i = 0; i < Joints.COUNT; i++) {
      result = mix(result, Double.doubleToRawLongBits(joints.get(i)));
    }
    return result;
  }

  private static long mix(long mixed, long more) {
    long result = (mixed ^ more) * FACTOR;
    return result ^ (result >>> 32);
  }

  private double timeS(ControllerState state) {
    return (state.frame() - start.frame()) * FrameTime.FRAME_S;
  }

  /** Robot time since the start, s. */
  double timeS() {
    return timeS(newest);
  }

  /** The last line that the program has reached; 0 before the first. */
  int line() {
    return line;
  }

  JointLoads torque() {
    return torque.loads();
  }

  JointLoads speed() {
    return speed.loads();
  }

  JointLoads current() {
    return current.loads();
  }

  double toolSpeedMPerS() {
    return toolSpeedMPerS;
  }

  double toolSpeedShare() {
    return toolSpeedShare;
  }

  double jointLimitRad() {
    return jointLimitRad;
  }

  double planeM() {
    return planeM;
  }

  double singularity() {
    return singularity;
  }

  double forceN() {
    return forceN;
  }

  double torqueNm() {
    return torqueNm;
  }

  double energyJ() {
    return newest.readings().energyConsumedJ() - start.readings().energyConsumedJ();
  }

  long digest() {
    return digest;
  }

  List<OutputChange> outputs() {
    return outputs;
  }

  /** Those that the program was in. */
  List<LineTime> lines() {
    List<LineTime> lines = new ArrayList<>();
    for (int i = 0; i < lineFrames.length; i++) {
      if (lineFrames[i] > 0) {
        lines.add(new LineTime(i, lineFrames[i]));
      }
    }
    return lines;
  }
}
