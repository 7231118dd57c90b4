package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;
import org.pendant.models.arm.Joints;

final class ProtectiveStopTest {
  private final SafetyBench bench = SafetyBench.standard().program(true);
  private final SafetySystem safety = bench.safety;

  private SafetyBench deviating(int joint, double deviationRad) {
    double there = SafetyBench.START.get(joint);
    return bench.arm(SafetyBench.START.with(joint, there + deviationRad), Joints.ZERO);
  }

  @Test
  void programAsksForAStop() {
    bench.step();
    safety.protectiveStop();
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(SafetyMode.PROTECTIVE_STOP, safety.safetyMode());
    assertEquals(
        "C209A0 protective stop at 0.004 s: the program asks for it", bench.stop().message());
    assertEquals(List.of(bench.stop().message()), bench.warnings());
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void aGuidedArmMayBePushedAndItsTargetMayBeAnywhere() {
    bench.guided(true).at(SafetyBench.START);
    bench.readings.setExternalTorque(1, 140);
    bench.steps(50);
    bench.at(SafetyBench.START.with(0, 0.3));
    assertEquals(-1, bench.stepsUntilAction(50));
    bench.guided(false);
    assertTrue(bench.stepsUntilAction(50) > 0, "held again, the push is a collision");
    assertEquals(157, bench.stop().code());
  }

  @Test
  void aToolThatPressesInForceModeIsNoCollisionButItsArmMustFollow() {
    bench.pressing(true).at(SafetyBench.START);
    bench.readings.setExternalTorque(1, 140);
    assertEquals(-1, bench.stepsUntilAction(40));
    bench.readings.setExternalTorque(1, 0);
    deviating(2, 0.051);
    assertTrue(bench.stepsUntilAction(50) > 0);
    assertEquals(153, bench.stop().code());
  }

  @Test
  void aGuidedArmIsStoppedBeforeTheEndOfAJoint() {
    bench.guided(true).at(SafetyBench.START.with(0, 6.2)).step();
    bench.target(SafetyBench.START.with(0, 6.25), SafetyBench.speed(0, 3));
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(150, bench.stop().code());
  }

  @Test
  void aWrongPayloadStopsOnce() {
    safety.wrongPayload(19.6, 7.4);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(
        "C155A0 protective stop at 0.002 s: the declared payload is not what the flange carries,"
            + " or something pushes the tool: 19.6 N, limit 7.4 N",
        bench.stop().message());
    safety.powerOff();
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void unlockingNeedsFiveSeconds() {
    safety.protectiveStop();
    bench.step();
    bench.steps(900);
    assertEquals(
        Optional.of("the protective stop can be unlocked 5 s after it happened, 3.2 s are left"),
        safety.unlockProtectiveStop(false).map(Refusal::text));
    bench.steps(1599);
    assertTrue(safety.unlockProtectiveStop(false).isPresent());
    bench.step();
    assertEquals(Optional.empty(), safety.unlockProtectiveStop(false));
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void whoNeedNotLookUnlocksAtOnce() {
    safety.protectiveStop();
    bench.step();
    assertEquals(Optional.empty(), safety.unlockProtectiveStop(true));
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void nothingToUnlock() {
    assertEquals(
        Optional.of("there is no protective stop to unlock"),
        safety.unlockProtectiveStop(false).map(Refusal::text));
  }

  @Test
  void programWaitsForUnlocking() {
    safety.protectiveStop();
    bench.step();
    assertEquals(
        Optional.of(
            "C209A0 protective stop at 0.002 s: the program asks for it;"
                + " unlock the protective stop first"),
        safety.programRefusal().map(Refusal::text));
  }

  @Test
  void powerOffEndsAProtectiveStop() {
    safety.protectiveStop();
    bench.step();
    safety.powerOff();
    assertEquals(SafetyMode.NORMAL, safety.safetyMode());
  }

  @Test
  void deviationOfTheElbowStopsAfterTwentyMilliseconds() {
    deviating(2, 0.051);
    assertEquals(10, bench.stepsUntilAction(100));
    assertEquals(153, bench.stop().code());
    assertEquals(2, bench.stop().argument());
    assertEquals(OptionalInt.of(2), bench.stop().joint());
    assertEquals("C153A2", bench.stop().codeText());
    assertEquals(
        "C153A2 protective stop at 0.020 s: elbow (joint 2) is away from its target: 0.051 rad,"
            + " limit 0.05 rad",
        bench.stop().message());
  }

  @Test
  void smallDeviationIsNoMatter() {
    deviating(2, 0.0499);
    assertEquals(-1, bench.stepsUntilAction(100));
  }

  @Test
  void wristsMayDeviateMore() {
    deviating(3, 0.099);
    assertEquals(-1, bench.stepsUntilAction(100));
    deviating(3, -0.101);
    assertEquals(10, bench.stepsUntilAction(100));
    assertEquals("C153A3", bench.stop().codeText());
  }

  @Test
  void deviationMustLast() {
    deviating(0, 0.06).steps(9);
    deviating(0, 0).step();
    deviating(0, 0.06).steps(9);
    assertTrue(safety.stop().isEmpty());
  }

  @Test
  void steadyArmMayDeviateMore() {
    bench.steady(true);
    deviating(1, 0.199);
    assertEquals(-1, bench.stepsUntilAction(100));
    deviating(1, 0.201);
    assertEquals(10, bench.stepsUntilAction(100));
  }

  @Test
  void steadyArmWithoutHighHoldingTorqueIsAsSensitiveAsAMovingOne() {
    safety.setHighHoldingTorque(false);
    bench.steady(true);
    deviating(1, 0.06);
    assertEquals(10, bench.stepsUntilAction(100));
  }

  @Test
  void collisionStopsAfterTenMilliseconds() {
    bench.readings.setExternalTorque(2, 53);
    assertEquals(5, bench.stepsUntilAction(100));
    assertEquals(
        "C157A2 protective stop at 0.010 s: elbow (joint 2) is pushed from outside: 53 Nm,"
            + " limit 52.5 Nm",
        bench.stop().message());
  }

  @Test
  void smallPushIsNoCollision() {
    bench.readings.setExternalTorque(2, 52);
    bench.readings.setExternalTorque(5, -9.7);
    assertEquals(-1, bench.stepsUntilAction(100));
  }

  @Test
  void shakingIsNoCollision() {
    for (int i = 0; i < 100; i++) {
      bench.readings.setExternalTorque(2, i / 3 % 2 == 0 ? 60 : -60);
      assertEquals(SafetyAction.NONE, bench.step());
    }
  }

  @Test
  void holdingArmTakesTwiceThePush() {
    bench.steady(true).readings.setExternalTorque(2, 104);
    assertEquals(-1, bench.stepsUntilAction(100));
    bench.readings.setExternalTorque(2, 106);
    assertEquals(5, bench.stepsUntilAction(100));
    assertEquals("C157A2", bench.stop().codeText());
  }

  @Test
  void collisionDuringASafeguardStopNeedsUnlocking() {
    safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    bench.step();
    bench.readings.setExternalTorque(0, 100);
    assertEquals(5, bench.stepsUntilAction(100));
    assertEquals(SafetyMode.PROTECTIVE_STOP, safety.safetyMode());
    bench.readings.setExternalTorque(0, 0);
    bench.steps(2500);
    safety.setInput(SafetyInput.SAFEGUARD_STOP, false);
    safety.unlockProtectiveStop(false);
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void safeguardInputStillHoldsTheArmAfterUnlocking() {
    safety.protectiveStop();
    bench.step();
    safety.setInput(SafetyInput.SAFEGUARD_STOP, true);
    bench.program(false).steps(2500);
    assertEquals(SafetyMode.PROTECTIVE_STOP, safety.safetyMode());
    safety.unlockProtectiveStop(false);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(SafetyMode.SAFEGUARD_STOP, safety.safetyMode());
    safety.setInput(SafetyInput.SAFEGUARD_STOP, false);
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void jumpOfTheTargetStops() {
    bench.step();
    bench.at(SafetyBench.START.with(0, 0.01));
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(
        "C204A1 protective stop at 0.004 s: base (joint 0) has a target position that jumps:"
            + " 0.01 rad, limit 0.006912 rad",
        bench.stop().message());
  }

  @Test
  void targetMayMoveAtFullSpeed() {
    bench.step();
    Joints q = SafetyBench.START;
    for (int i = 0; i < 100; i++) {
      q = q.with(0, q.get(0) + Math.PI * 0.002);
      assertEquals(SafetyAction.NONE, bench.at(q).step());
    }
  }

  @Test
  void jumpOfTheTargetSpeedStops() {
    bench.target(SafetyBench.START, SafetyBench.speed(4, 0.9)).step();
    assertTrue(safety.stop().isEmpty());
    bench.target(SafetyBench.START, SafetyBench.speed(4, -0.2));
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals("C204A3", bench.stop().codeText());
    assertEquals(OptionalInt.of(4), bench.stop().joint());
  }

  @Test
  void armThatWasPutElsewhereMayJump() {
    bench.step();
    bench.at(SafetyBench.START.with(0, 1));
    safety.jumped();
    assertEquals(SafetyAction.NONE, bench.step());
    assertEquals(SafetyAction.NONE, bench.step());
    bench.at(SafetyBench.START.with(0, 2));
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
  }

  @Test
  void targetMayJumpWhileAStopLasts() {
    safety.protectiveStop();
    bench.step();
    bench.at(SafetyBench.START.with(0, 0.1)).steps(2500);
    safety.unlockProtectiveStop(false);
    assertEquals(SafetyAction.NONE, bench.step());
  }
}
