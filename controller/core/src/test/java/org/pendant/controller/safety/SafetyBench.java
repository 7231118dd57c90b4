package org.pendant.controller.safety;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.arm.SensorReadings;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.MessageLog;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;
import org.pendant.models.time.FrameTime;

/** A safety system and the arm, target and program that a test makes up for it. */
final class SafetyBench {
  /** Forearm level, tool down, away from everything. */
  static final Joints START =
      new Joints(0, -Math.PI / 2, -Math.PI / 2, -Math.PI / 2, Math.PI / 2, 0);

  final ArmDescription arm;
  final MessageLog log = new MessageLog();
  final SafetySystem safety;
  final SensorReadings readings = new SensorReadings();

  private long frame;
  private Joints target = START;
  private Joints targetSpeed = Joints.ZERO;
  private Joints actual = START;
  private Joints actualSpeed = Joints.ZERO;
  private Wrench wrench = Wrench.ZERO;
  private boolean steady;
  private boolean program;
  private boolean guided;
  private boolean pressing;

  SafetyBench(ArmDescription arm, SafetyConfiguration configuration, boolean running) {
    this.arm = arm;
    safety = new SafetySystem(arm, configuration, log, running);
  }

  /** A running UR5e as it comes, whose changes of power take these times. */
  SafetyBench(PowerTimes times) {
    arm = ArmLibrary.load("ur5e");
    safety = new SafetySystem(arm, new ArmDynamics(arm), standardOfUr5e(), log, true, times);
  }

  /** A running UR5e with these limits and planes. */
  static SafetyBench with(SafetyConfiguration configuration) {
    return new SafetyBench(ArmLibrary.load("ur5e"), configuration, true);
  }

  /** A running UR5e as it comes. */
  static SafetyBench standard() {
    return with(standardOfUr5e());
  }

  /** A UR5e as it comes, switched off. */
  static SafetyBench off() {
    return new SafetyBench(ArmLibrary.load("ur5e"), standardOfUr5e(), false);
  }

  static SafetyConfiguration standardOfUr5e() {
    return SafetyConfiguration.standard(ArmLibrary.load("ur5e"));
  }

  /** Target and arm are there, at rest. */
  SafetyBench at(Joints position) {
    return target(position, Joints.ZERO).arm(position, Joints.ZERO);
  }

  SafetyBench target(Joints position, Joints speed) {
    target = position;
    targetSpeed = speed;
    return this;
  }

  SafetyBench arm(Joints position, Joints speed) {
    actual = position;
    actualSpeed = speed;
    return this;
  }

  SafetyBench wrench(Wrench atFlangeInBase) {
    wrench = atFlangeInBase;
    return this;
  }

  SafetyBench steady(boolean resting) {
    steady = resting;
    return this;
  }

  SafetyBench program(boolean running) {
    program = running;
    return this;
  }

  SafetyBench pressing(boolean inForceMode) {
    pressing = inForceMode;
    return this;
  }

  SafetyBench guided(boolean byHand) {
    guided = byHand;
    return this;
  }

  SafetyAction step() {
    frame++;
    log.setTime(timeS());
    return safety.step(facts());
  }

  /** What the system is shown. */
  FrameFacts facts() {
    readings.set(actual, actualSpeed);
    return new FrameFacts(
        timeS(),
        JointNumbers.of(target),
        JointNumbers.of(targetSpeed),
        readings.sensors(),
        Pose.ZERO,
        WrenchNumbers.of(wrench),
        steady,
        !targetSpeed.equals(Joints.ZERO),
        program,
        guided,
        pressing);
  }

  /** Steps until something has to be done; the number of frames that took, or -1 for too many. */
  int stepsUntilAction(int most) {
    for (int i = 1; i <= most; i++) {
      if (step() != SafetyAction.NONE) {
        return i;
      }
    }
    return -1;
  }

  void steps(int count) {
    for (int i = 0; i < count; i++) {
      step();
    }
  }

  double timeS() {
    return frame * FrameTime.FRAME_S;
  }

  SafetyStop stop() {
    return safety.stop().orElseThrow();
  }

  List<String> warnings() {
    return texts(LogEntry.Level.WARNING);
  }

  List<String> texts(LogEntry.Level level) {
    List<String> texts = new ArrayList<>();
    for (LogEntry entry : log.since(0)) {
      if (entry.level() == level) {
        texts.add(entry.text());
      }
    }
    return texts;
  }

  /** Speed {@code value} of joint {@code joint} alone, rad/s. */
  static Joints speed(int joint, double value) {
    return Joints.ZERO.with(joint, value);
  }
}
