package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;
import org.pendant.models.arm.Joints;
import org.pendant.models.kinematics.ForwardKinematics;

/** Reduced mode, recovery, warnings and pauses. */
final class ModeTest {
  private static final SafetyConfiguration STANDARD = SafetyBench.standardOfUr5e();

  /** Faster than the reduced limit of a joint, slower than the normal one. */
  private static final Joints FAST = SafetyBench.speed(5, 2);

  private final SafetyBench bench = SafetyBench.standard().program(true);
  private final SafetySystem safety = bench.safety;

  @Test
  void inputSwitchesToTheReducedLimits() {
    assertEquals(STANDARD.normal(), safety.limits());
    safety.setInput(SafetyInput.REDUCED_MODE, true);
    assertEquals(SafetyAction.NONE, bench.step());
    assertEquals(SafetyMode.REDUCED, safety.safetyMode());
    assertTrue(safety.reduced());
    assertEquals(STANDARD.reduced(), safety.limits());
    assertEquals(Optional.empty(), safety.programRefusal());
    safety.setInput(SafetyInput.REDUCED_MODE, false);
    bench.step();
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
    assertEquals(STANDARD.normal(), safety.limits());
  }

  @Test
  void armHasHalfASecondToSlowDown() {
    bench.target(SafetyBench.START, FAST).arm(SafetyBench.START, FAST).step();
    safety.setInput(SafetyInput.REDUCED_MODE, true);
    bench.step();
    assertEquals(250, bench.stepsUntilAction(1000));
    assertEquals("C191A1", bench.stop().codeText());
  }

  @Test
  void reducedInputShowsWithoutPower() {
    SafetyBench off = SafetyBench.off();
    off.safety.setInput(SafetyInput.REDUCED_MODE, true);
    off.step();
    assertEquals(SafetyMode.REDUCED, off.safety.safetyMode());
  }

  private static SafetyBench triggered(double heightM) {
    SafetyPlane trigger =
        new SafetyPlane("low", 0, 0, heightM, new Axis(0, 0, 1), Applies.TRIGGERS_REDUCED, false);
    return SafetyBench.with(STANDARD.withPlanes(trigger)).program(true);
  }

  private static double heightM(Joints q) {
    return new ForwardKinematics(SafetyBench.standard().arm).flangePose(q).z();
  }

  @Test
  void planeSwitchesBeyondItAndBackAfterTwoCentimetres() {
    double height = heightM(SafetyBench.START);
    SafetyBench before = triggered(height - 0.001);
    before.step();
    assertFalse(before.safety.reduced());

    SafetyBench beyond = triggered(height + 0.001);
    beyond.step();
    assertEquals(SafetyMode.REDUCED, beyond.safety.safetyMode());
    Joints higher = SafetyBench.START.with(2, SafetyBench.START.q2() + 0.03);
    assertTrue(heightM(higher) - height > 0.005 && heightM(higher) - height < 0.02);
    beyond.at(higher);
    beyond.safety.jumped();
    beyond.step();
    assertTrue(beyond.safety.reduced(), "in the band of 2 cm");
    Joints high = SafetyBench.START.with(2, SafetyBench.START.q2() + 0.1);
    assertTrue(heightM(high) - height > 0.021);
    beyond.at(high);
    beyond.safety.jumped();
    beyond.step();
    assertFalse(beyond.safety.reduced());
  }

  @Test
  void beyondATriggerPlaneTheReducedLimitsHoldAtOnce() {
    SafetyBench beyond = triggered(heightM(SafetyBench.START) + 0.001);
    beyond.arm(SafetyBench.START, FAST).target(SafetyBench.START, FAST);
    assertEquals(SafetyAction.OFF_NOW, beyond.step());
    assertEquals("C191A1", beyond.stop().codeText());
  }

  private static Joints beyondRange() {
    return SafetyBench.START.with(5, 2 * Math.PI + 0.2);
  }

  private static SafetyBench recovering() {
    SafetyBench bench = SafetyBench.standard().at(beyondRange());
    bench.step();
    return bench;
  }

  @Test
  void armThatWakesUpBeyondALimitRecovers() {
    SafetyBench recovering = recovering();
    assertEquals(SafetyMode.RECOVERY, recovering.safety.safetyMode());
    assertTrue(recovering.safety.stop().isEmpty());
    assertEquals(
        Optional.of(
            "the arm is beyond a safety limit, must be brought back by hand first (RECOVERY)"),
        recovering.safety.programRefusal().map(Refusal::text));
    assertEquals(
        List.of(
            "recovery mode: C191A0 violation at 0.002 s: wrist 3 (joint 5) is beyond its position"
                + " limit: 6.483 rad, limit 6.336 rad"),
        recovering.warnings());
  }

  @Test
  void recoveryHasLimitsOfItsOwn() {
    SafetyBench recovering = recovering();
    assertEquals(Math.toRadians(30), recovering.safety.limits().jointSpeedRadPerS().q0());
    assertEquals(0.25, recovering.safety.limits().toolSpeedMPerS());
    Joints slow = SafetyBench.speed(5, -0.5);
    recovering.arm(beyondRange(), slow).target(beyondRange(), slow);
    assertEquals(SafetyAction.NONE, recovering.step());
    Joints fast = SafetyBench.speed(5, -0.6);
    recovering.arm(beyondRange(), fast).target(beyondRange(), fast);
    assertEquals(SafetyAction.OFF_NOW, recovering.step());
  }

  @Test
  void recoveryEndsWithinTheLimits() {
    SafetyBench recovering = recovering();
    recovering.at(SafetyBench.START.with(5, 2 * Math.PI + 0.06));
    recovering.safety.jumped();
    recovering.step();
    assertEquals(SafetyMode.RECOVERY, recovering.safety.safetyMode());
    recovering.at(SafetyBench.START.with(5, 2 * Math.PI));
    recovering.safety.jumped();
    recovering.step();
    assertEquals(SafetyMode.NORMAL, recovering.safety.safetyMode());
    assertEquals(Optional.empty(), recovering.safety.programRefusal());
  }

  @Test
  void programThatStartsBeyondALimitIsStopped() {
    SafetyBench beyond = SafetyBench.standard().at(beyondRange()).program(true);
    assertEquals(SafetyAction.OFF_NOW, beyond.step());
  }

  @Test
  void deviationIsWarnedOfOnceASecond() {
    safety.positionDeviationWarning(true, 0.8);
    bench.arm(SafetyBench.START.with(0, 0.041), Joints.ZERO).steps(500);
    assertEquals(
        List.of(
            "C173A0 warning at 0.002 s: base (joint 0) is away from its target: 0.041 rad,"
                + " limit 0.04 rad"),
        bench.warnings());
    bench.step();
    assertEquals(2, bench.warnings().size());
  }

  @Test
  void eachJointIsWarnedOf() {
    safety.positionDeviationWarning(true, 0);
    bench.arm(SafetyBench.START.with(0, 0.001).with(4, 0), Joints.ZERO).steps(2);
    assertEquals(2, bench.warnings().size());
  }

  @Test
  void smallDeviationIsNotWarnedOf() {
    safety.positionDeviationWarning(true, 0.8);
    bench.arm(SafetyBench.START.with(0, 0.039), Joints.ZERO).steps(100);
    assertEquals(List.of(), bench.warnings());
  }

  @Test
  void warningsAreOffUntilAskedFor() {
    bench.arm(SafetyBench.START.with(0, 0.045), Joints.ZERO).steps(100);
    safety.positionDeviationWarning(true, 0.8);
    safety.positionDeviationWarning(false, 0.8);
    bench.steps(100);
    assertEquals(List.of(), bench.warnings());
  }

  @Test
  void thresholdIsAShare() {
    assertEquals(
        "threshold is 1.5, must be 0 to 1",
        assertThrows(
                IllegalArgumentException.class, () -> safety.positionDeviationWarning(true, 1.5))
            .getMessage());
  }

  private SafetyAction actionAtADeviation() {
    safety.positionDeviationWarning(true, 0.5);
    return bench.arm(SafetyBench.START.with(3, SafetyBench.START.q3() + 0.06), Joints.ZERO).step();
  }

  @Test
  void programPausesOnAnErrorThatItNames() {
    safety.pauseOnErrorCode(173, OptionalInt.of(3));
    assertEquals(SafetyAction.PAUSE, actionAtADeviation());
    assertTrue(safety.stop().isEmpty());
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void programPausesOnAnyArgument() {
    safety.pauseOnErrorCode(173, OptionalInt.empty());
    assertEquals(SafetyAction.PAUSE, actionAtADeviation());
  }

  @Test
  void otherArgumentDoesNotPause() {
    safety.pauseOnErrorCode(173, OptionalInt.of(2));
    assertEquals(SafetyAction.NONE, actionAtADeviation());
  }

  @Test
  void pausesAreForgottenWhenTheProgramStops() {
    safety.pauseOnErrorCode(173, OptionalInt.empty());
    safety.programStopped();
    assertEquals(SafetyAction.NONE, actionAtADeviation());
  }

  @Test
  void nothingPausesWithoutAProgram() {
    safety.pauseOnErrorCode(173, OptionalInt.empty());
    bench.program(false);
    assertEquals(SafetyAction.NONE, actionAtADeviation());
  }

  @Test
  void stopThatTheProgramNamesIsStillAStop() {
    safety.pauseOnErrorCode(153, OptionalInt.empty());
    bench.arm(SafetyBench.START.with(0, 0.06), Joints.ZERO);
    assertEquals(10, bench.stepsUntilAction(20));
    assertEquals(SafetyMode.PROTECTIVE_STOP, safety.safetyMode());
  }
}
