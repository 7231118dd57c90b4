package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.message.LogEntry;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.kinematics.Jacobian;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;

final class ViolationTest {
  private static final SafetyConfiguration STANDARD = SafetyBench.standardOfUr5e();

  private final SafetyBench bench = SafetyBench.standard().program(true);
  private final SafetySystem safety = bench.safety;

  /** Lets a joint turn that fast, target and arm. */
  private SafetyBench turning(SafetyBench some, int joint, double speedRadPerS) {
    Joints speed = SafetyBench.speed(joint, speedRadPerS);
    return some.target(SafetyBench.START, speed).arm(SafetyBench.START, speed);
  }

  private static SafetyLimits limits(
      double momentum, double toolSpeed, double elbowSpeed, double powerW) {
    SafetyLimits n = STANDARD.normal();
    return new SafetyLimits(
        powerW,
        momentum,
        n.stoppingTimeS(),
        n.stoppingDistanceM(),
        toolSpeed,
        n.toolForceN(),
        elbowSpeed,
        n.elbowForceN(),
        n.jointSpeedRadPerS(),
        n.jointMinRad(),
        n.jointMaxRad());
  }

  private static SafetyBench limited(SafetyLimits limits) {
    return SafetyBench.with(STANDARD.withLimits(limits, STANDARD.reduced().tighterOf(limits)))
        .program(true);
  }

  @Test
  void violationCutsThePowerAtOnceAndNeedsARestart() {
    turning(bench, 5, 3.4);
    assertEquals(SafetyAction.OFF_NOW, bench.step());
    assertEquals(RobotMode.POWER_OFF, safety.robotMode());
    assertEquals(SafetyMode.VIOLATION, safety.safetyMode());
    assertEquals(StopCategory.ZERO, bench.stop().category());
    assertEquals(
        "C191A1 violation at 0.002 s: wrist 3 (joint 5) turns too fast: 3.4 rad/s,"
            + " limit 3.33 rad/s",
        bench.stop().message());
    assertEquals(List.of(bench.stop().message()), bench.texts(LogEntry.Level.ERROR));
    assertEquals(SafetyAction.NONE, bench.step());
    assertEquals(
        Optional.of(
            bench.stop().message() + "; restart the safety functions, then power the arm on"),
        safety.powerOn().map(Refusal::text));
    assertEquals(safety.powerOn(), safety.programRefusal());
    assertEquals(Optional.empty(), safety.restartSafety());
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
    assertEquals(RobotMode.POWER_OFF, safety.robotMode());
    assertEquals(Optional.empty(), safety.powerOn());
  }

  @Test
  void nothingToRestart() {
    assertEquals(
        Optional.of("there is no violation or fault, nothing has to be restarted"),
        safety.restartSafety().map(Refusal::text));
  }

  @Test
  void jointAtFaultReportsIt() {
    turning(bench, 5, 3.4).step();
    assertEquals(251, safety.jointMode(5).code());
    assertEquals(239, safety.jointMode(0).code());
  }

  @Test
  void jointSpeedMayExceedItsLimitByWhatCannotBeMeasured() {
    double limit = STANDARD.normal().jointSpeedRadPerS().q5();
    turning(bench, 5, limit + Math.toRadians(1.14)).step();
    assertTrue(safety.stop().isEmpty());
    turning(bench, 5, -limit - Math.toRadians(1.16)).step();
    assertEquals("C191A1", bench.stop().codeText());
  }

  @Test
  void toolSpeedMayExceedItsLimitByFiveCentimetresASecond() {
    ArmPoints points = new ArmPoints(bench.arm);
    points.at(SafetyBench.START.toArray(), SafetyBench.speed(0, 1).toArray(), Pose.ZERO);
    double speed = points.toolSpeedMPerS();
    SafetyBench tight = limited(limits(25, 0.5, 1.5, 300));
    turning(tight, 0, 0.549 / speed).step();
    assertTrue(tight.safety.stop().isEmpty());
    turning(tight, 0, 0.551 / speed).step();
    assertEquals(
        "C191A2 violation at 0.004 s: tool moves too fast: 0.551 m/s, limit 0.5 m/s",
        tight.stop().message());
  }

  @Test
  void elbowSpeedMayExceedItsLimitByFiveCentimetresASecond() {
    double upperArmM = 0.425;
    SafetyBench tight = limited(limits(25, 1.5, 0.2, 300));
    turning(tight, 1, 0.249 / upperArmM).step();
    assertTrue(tight.safety.stop().isEmpty());
    turning(tight, 1, 0.251 / upperArmM).step();
    assertEquals(
        "C191A3 violation at 0.004 s: elbow moves too fast: 0.251 m/s, limit 0.2 m/s",
        tight.stop().message());
  }

  @Test
  void momentumMayExceedItsLimitByThree() {
    double[] momentum = new double[3];
    new ArmDynamics(bench.arm)
        .linearMomentum(SafetyBench.START.toArray(), SafetyBench.speed(0, 1).toArray(), momentum);
    double perSpeed = Observation.length(momentum);
    SafetyBench tight = limited(limits(2, 1.5, 1.5, 300));
    turning(tight, 0, 4.99 / perSpeed).step();
    assertTrue(tight.safety.stop().isEmpty());
    turning(tight, 0, 5.01 / perSpeed).step();
    assertEquals("C191A4", tight.stop().codeText());
    assertEquals("kg m/s", tight.stop().unit());
  }

  @Test
  void jointPositionMayExceedItsLimitByFiveDegrees() {
    double limit = 2 * Math.PI + Math.toRadians(3);
    bench.at(SafetyBench.START.with(5, limit + Math.toRadians(4.9))).step();
    assertTrue(safety.stop().isEmpty());
    bench.at(SafetyBench.START.with(5, limit + Math.toRadians(5.1))).step();
    assertEquals("C191A0", bench.stop().codeText());
    assertEquals(limit, bench.stop().limit(), 1e-12);
  }

  @Test
  void wristOfTheSmallestArmTurnsWithoutEnd() {
    var small = ArmLibrary.load("ur3e");
    SafetyBench endless = new SafetyBench(small, SafetyConfiguration.standard(small), true);
    endless.at(SafetyBench.START.with(5, 1000)).step();
    assertTrue(endless.safety.stop().isEmpty());
  }

  @Test
  void pressingForATenthOfASecondIsAViolation() {
    bench.wrench(new Wrench(0, 0, 176, 0, 0, 0));
    assertEquals(50, bench.stepsUntilAction(100));
    assertEquals(
        "C191A6 violation at 0.100 s: tool is pressed too hard: 176 N, limit 150 N",
        bench.stop().message());
  }

  @Test
  void forceMayExceedItsLimitByTwentyFiveNewton() {
    bench.wrench(new Wrench(0, 174, 0, 0, 0, 0));
    // the drives feel the same load, so the elbow is left out of it
    balanceWrenchAtFlange(new Wrench(0, 174, 0, 0, 0, 0));
    bench.steady(true);
    assertEquals(-1, bench.stepsUntilAction(200));
  }

  /** Lets the joints feel a load at the flange as the drives of a resting arm would. */
  private void balanceWrenchAtFlange(Wrench load) {
    balanceWrenchAtFlange(load, SafetyBench.START);
  }

  private void balanceWrenchAtFlange(Wrench load, Joints position) {
    double[] jacobian = new double[Jacobian.SIZE];
    double[] torque = new double[Joints.COUNT];
    new Jacobian(bench.arm).at(position.toArray(), Pose.ZERO, jacobian);
    double[] six = {load.fx(), load.fy(), load.fz(), load.mx(), load.my(), load.mz()};
    Jacobian.transposed(jacobian, six, torque);
    for (int i = 0; i < Joints.COUNT; i++) {
      bench.readings.setExternalTorque(i, -torque[i]);
    }
  }

  @Test
  void loadOnTheToolIsNoForceAtTheElbow() {
    Random random = new Random(5);
    for (int k = 0; k < 1000; k++) {
      double[] q = random.doubles(Joints.COUNT, -6, 6).toArray();
      double[] w = random.doubles(6, -100, 100).toArray();
      Wrench load = new Wrench(w[0], w[1], w[2], w[3], w[4], w[5]);
      bench.at(Joints.of(q)).wrench(load);
      balanceWrenchAtFlange(load, Joints.of(q));
      assertEquals(0, elbowForceN(), 1e-9, "state " + k);
    }
  }

  @Test
  void shortBlowIsNoPress() {
    for (int i = 0; i < 200; i++) {
      bench.wrench(i % 50 == 49 ? Wrench.ZERO : new Wrench(0, 0, 400, 0, 0, 0));
      assertEquals(SafetyAction.NONE, bench.step());
    }
  }

  @Test
  void pressThatAStopFollowedIsNoViolation() {
    bench.wrench(new Wrench(0, 0, 400, 0, 0, 0)).steps(20);
    safety.protectiveStop();
    bench.steps(1000);
    assertEquals(SafetyMode.PROTECTIVE_STOP, safety.safetyMode());
  }

  @Test
  void forceAtTheElbowIsWhatTheToolDoesNotExplain() {
    double upperArmM = 0.425;
    // at the start the upper arm points up, a level push at the elbow turns the shoulder
    bench.steady(true).readings.setExternalTorque(1, 104);
    assertEquals(104 / upperArmM, elbowForceN(), 1e-9);
    bench.readings.setExternalTorque(1, 0);
    balanceWrenchAtFlange(new Wrench(30, -20, 50, 0, 0, 0));
    bench.wrench(new Wrench(30, -20, 50, 0, 0, 0));
    assertEquals(0, elbowForceN(), 1e-9);
  }

  private double elbowForceN() {
    Observation seen = new Observation(bench.arm, new ArmDynamics(bench.arm), false);
    seen.take(bench.facts());
    seen.evaluate(bench.facts());
    return PressCheck.elbowForceN(bench.facts(), seen);
  }

  @Test
  void pressOnTheElbowIsAViolation() {
    bench.steady(true).readings.setExternalTorque(1, -0.425 * 176);
    assertEquals(50, bench.stepsUntilAction(100));
    assertEquals(
        "C191A7 violation at 0.100 s: elbow is pressed too hard: 176 N, limit 150 N",
        bench.stop().message());
  }

  @Test
  void workOnTheSurroundingsIsLimited() {
    SafetyBench tight = limited(limits(25, 1.5, 1.5, 20));
    turning(tight, 2, 1);
    tight.readings.setExternalTorque(2, 29.9);
    assertEquals(-1, tight.stepsUntilAction(100));
    tight.readings.setExternalTorque(2, 30.1);
    assertEquals(50, tight.stepsUntilAction(100));
    assertEquals(
        "C191A5 violation at 0.300 s: arm does too much work on its surroundings: 30.1 W,"
            + " limit 20 W",
        tight.stop().message());
  }

  @Test
  void sensorWithoutANumberIsAFault() {
    bench.arm(SafetyBench.START.with(3, Double.NaN), Joints.ZERO);
    assertEquals(SafetyAction.OFF_NOW, bench.step());
    assertEquals(SafetyMode.FAULT, safety.safetyMode());
    assertEquals(
        "C192A0 fault at 0.002 s: wrist 1 (joint 3) reports no number", bench.stop().message());
    assertEquals(252, safety.jointMode(3).code());
    bench.at(SafetyBench.START);
    assertEquals(Optional.empty(), safety.restartSafety());
  }

  @Test
  void violationEndsAProtectiveStop() {
    safety.protectiveStop();
    bench.step();
    turning(bench, 0, 4);
    assertEquals(SafetyAction.OFF_NOW, bench.step());
    assertEquals(SafetyMode.VIOLATION, safety.safetyMode());
  }

  @Test
  void armWithoutPowerViolatesNothing() {
    SafetyBench off = SafetyBench.off();
    turning(off, 0, 10);
    assertEquals(-1, off.stepsUntilAction(10));
  }
}
