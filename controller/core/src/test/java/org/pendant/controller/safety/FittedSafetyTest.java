package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

class FittedSafetyTest {
  private static final ArmDescription UR5E = ArmLibrary.load("ur5e");
  private static final SafetyConfiguration STANDARD = SafetyConfiguration.standard(UR5E);

  private static Joints all(double value) {
    double[] values = new double[Joints.COUNT];
    Arrays.fill(values, value);
    return Joints.of(values);
  }

  private static SafetyLimits joints(SafetyLimits l, Joints speed, Joints min, Joints max) {
    return new SafetyLimits(
        l.powerW(),
        l.momentumKgMPerS(),
        l.stoppingTimeS(),
        l.stoppingDistanceM(),
        l.toolSpeedMPerS(),
        l.toolForceN(),
        l.elbowSpeedMPerS(),
        l.elbowForceN(),
        speed,
        min,
        max);
  }

  private static List<String> fields(FittedSafety fitted) {
    return fitted.changes().stream().map(FittedSafety.Change::field).toList();
  }

  @Test
  void whatEveryArmHasByItselfStaysAsItIs() {
    for (ArmDescription arm : ArmLibrary.ids().stream().map(ArmLibrary::load).toList()) {
      SafetyConfiguration standard = SafetyConfiguration.standard(arm);
      assertEquals(new FittedSafety(standard, List.of()), FittedSafety.of(standard, arm));
    }
  }

  @Test
  void theJointSpeedsOfRobotsStayAsTheyAre() {
    SafetyLimits robot =
        joints(
            STANDARD.normal(),
            all(Math.PI + 0.2),
            STANDARD.normal().jointMinRad(),
            STANDARD.normal().jointMaxRad());
    SafetyConfiguration safety = STANDARD.withLimits(robot, robot);
    assertEquals(new FittedSafety(safety, List.of()), FittedSafety.of(safety, UR5E));
  }

  @Test
  void whatTheArmCannotDoIsTakenBackAndTold() {
    SafetyLimits wide =
        joints(
            STANDARD.normal(),
            STANDARD.normal().jointSpeedRadPerS().with(4, 6.4832),
            STANDARD.normal().jointMinRad().with(1, -50),
            STANDARD.normal().jointMaxRad().with(2, 50));
    FittedSafety fitted = FittedSafety.of(STANDARD.withLimits(wide, wide), UR5E);
    assertEquals(Math.PI + 0.2, fitted.configuration().normal().jointSpeedRadPerS().get(4), 1e-9);
    assertEquals(STANDARD.normal().jointMinRad(), fitted.configuration().normal().jointMinRad());
    assertEquals(STANDARD.normal().jointMaxRad(), fitted.configuration().reduced().jointMaxRad());
    assertEquals(
        List.of("normal.jointMinRad", "normal.jointMinRad", "normal.jointSpeedRadPerS"),
        fields(fitted).stream().sorted().toList());
    assertTrue(
        fitted.changes().getLast().message().startsWith("joint 4 may turn at 6.4832 rad/s, must"),
        fitted.changes().getLast()::message);
  }

  @Test
  void aRangeBesideThatOfTheArmIsThatOfTheArm() {
    SafetyLimits beside =
        joints(
            STANDARD.normal(),
            STANDARD.normal().jointSpeedRadPerS(),
            STANDARD.normal().jointMinRad().with(0, 20),
            STANDARD.normal().jointMaxRad().with(0, 30));
    FittedSafety fitted = FittedSafety.of(STANDARD.withLimits(beside, beside), UR5E);
    assertEquals(STANDARD.normal(), fitted.configuration().normal());
    assertEquals(List.of("normal.jointMinRad"), fields(fitted));
  }

  @Test
  void infinityStandsForWhatTheArmHasByItself() {
    double no = Double.POSITIVE_INFINITY;
    SafetyLimits none =
        new SafetyLimits(no, no, no, no, no, no, no, no, all(no), all(-no), all(no));
    FittedSafety fitted = FittedSafety.of(STANDARD.withLimits(none, none), UR5E);
    assertEquals(
        STANDARD.withLimits(
            joints(
                STANDARD.normal(),
                STANDARD.normal().jointSpeedRadPerS(),
                none.jointMinRad(),
                none.jointMaxRad()),
            joints(
                STANDARD.reduced(),
                STANDARD.reduced().jointSpeedRadPerS(),
                none.jointMinRad(),
                none.jointMaxRad())),
        fitted.configuration());
    assertEquals(List.of(), fitted.changes());
  }
}
