package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

final class SafetyConfigurationTest {
  private static final SafetyConfiguration STANDARD = SafetyBench.standardOfUr5e();

  private static String refusal(Runnable attempt) {
    return assertThrows(IllegalArgumentException.class, attempt::run).getMessage();
  }

  @Test
  void standardOfUr5eIsWhatTheDocumentationSays() {
    SafetyLimits normal = STANDARD.normal();
    assertEquals(300, normal.powerW());
    assertEquals(25, normal.momentumKgMPerS());
    assertEquals(0.4, normal.stoppingTimeS());
    assertEquals(0.5, normal.stoppingDistanceM());
    assertEquals(1.5, normal.toolSpeedMPerS());
    assertEquals(150, normal.toolForceN());
    assertEquals(1.5, normal.elbowSpeedMPerS());
    assertEquals(150, normal.elbowForceN());
    assertEquals(1.06 * Math.PI, normal.jointSpeedRadPerS().q3(), 1e-12);
    assertEquals(Math.toRadians(363), normal.jointMaxRad().q2(), 1e-12);
    SafetyLimits reduced = STANDARD.reduced();
    assertEquals(200, reduced.powerW());
    assertEquals(10, reduced.momentumKgMPerS());
    assertEquals(0.3, reduced.stoppingTimeS(), 1e-12);
    assertEquals(0.3, reduced.stoppingDistanceM());
    assertEquals(0.75, reduced.toolSpeedMPerS());
    assertEquals(120, reduced.toolForceN());
    assertEquals(0.53 * Math.PI, reduced.jointSpeedRadPerS().q3(), 1e-12);
    assertEquals(List.of(), STANDARD.planes());
    assertEquals(Optional.empty(), STANDARD.toolDirection());
  }

  static List<String> everyArm() {
    return ArmLibrary.ids();
  }

  @ParameterizedTest
  @MethodSource("everyArm")
  void everyArmHasAStandardThatLeavesItsDataSheetUsable(String id) {
    ArmDescription arm = ArmLibrary.load(id);
    SafetyLimits limits = SafetyConfiguration.standard(arm).normal();
    double undeclaredPayloadN = arm.payloadKg() * 9.82;
    assertTrue(
        limits.toolForceN() + PressCheck.FORCE_TOLERANCE_N > undeclaredPayloadN,
        () -> id + ": " + limits.toolForceN());
    for (int i = 0; i < Joints.COUNT; i++) {
      double published = arm.joints().get(i).maxSpeedRadPerS();
      assertTrue(SpeedCaps.SHARE * limits.jointSpeedRadPerS().get(i) > published);
      assertTrue(SpeedCaps.SHARE * limits.stoppingTimeS() * 15 > published);
    }
  }

  @Test
  void fastArmsMayBeFast() {
    assertTrue(STANDARD.normal().toolSpeedMPerS() < 2);
    SafetyLimits ur15 = SafetyConfiguration.standard(ArmLibrary.load("ur15")).normal();
    assertTrue(0.97 * ur15.toolSpeedMPerS() > 5, () -> "UR15: " + ur15.toolSpeedMPerS());
    SafetyLimits ur20 = SafetyConfiguration.standard(ArmLibrary.load("ur20")).normal();
    assertTrue(0.97 * ur20.toolSpeedMPerS() > 2, () -> "UR20: " + ur20.toolSpeedMPerS());
  }

  @Test
  void limitsAreAboveZero() {
    assertEquals(
        "safety limits: tool speed is 0.0 m/s, must be above 0",
        refusal(
            () ->
                new SafetyLimits(
                    1, 1, 1, 1, 0, 1, 1, 1, new Joints(1, 1, 1, 1, 1, 1), Joints.ZERO, MAX)));
  }

  private static final Joints MAX = new Joints(1, 1, 1, 1, 1, 1);

  @Test
  void rangesAreNotEmpty() {
    assertEquals(
        "safety limits: joint 2 may be at 0.0 to 0.0 rad, the first must be below the second",
        refusal(() -> new SafetyLimits(1, 1, 1, 1, 1, 1, 1, 1, MAX, Joints.ZERO, MAX.with(2, 0))));
  }

  @Test
  void reducedLimitsAreNotWiderThanNormalOnes() {
    SafetyLimits wide = STANDARD.normal();
    SafetyLimits narrow = STANDARD.reduced();
    assertEquals(
        "reduced limits: power is 300.0 W, must be at most the normal 200.0 W",
        refusal(() -> STANDARD.withLimits(narrow, wide)));
  }

  @Test
  void reducedRangesAreWithinNormalOnes() {
    SafetyLimits narrow =
        new SafetyLimits(
            300,
            25,
            0.4,
            0.5,
            1.5,
            150,
            1.5,
            150,
            STANDARD.normal().jointSpeedRadPerS(),
            new Joints(-1, -1, -1, -1, -1, -1),
            MAX);
    assertTrue(
        refusal(() -> STANDARD.withLimits(narrow, STANDARD.reduced()))
            .startsWith("reduced limits: joint 0 may be at -6.3"));
  }

  private static SafetyPlane plane(String name) {
    return new SafetyPlane(name, 0, 0, 0, new Axis(0, 0, 1), Applies.BOTH, false);
  }

  @Test
  void planesHaveTheirOwnNames() {
    assertEquals(
        "two safety planes are called \"wall\", each must have its own name",
        refusal(() -> STANDARD.withPlanes(plane("wall"), plane("wall"))));
    assertEquals("safety plane: name is blank, must have a letter", refusal(() -> plane(" ")));
  }

  @Test
  void planesAreFew() {
    SafetyPlane[] nine = new SafetyPlane[9];
    for (int i = 0; i < nine.length; i++) {
      nine[i] = plane("plane " + i);
    }
    assertEquals(
        "safety configuration has 9 planes, must be at most 8",
        refusal(() -> STANDARD.withPlanes(nine)));
  }

  @Test
  void planesAreSomewhere() {
    assertEquals(
        "safety plane wall: point is [NaN, 0.0, 0.0] m, must be finite",
        refusal(
            () ->
                new SafetyPlane("wall", Double.NaN, 0, 0, new Axis(1, 0, 0), Applies.BOTH, true)));
  }

  @Test
  void directionsHaveLengthOne() {
    assertEquals(new Axis(0.6, 0, 0.8), new Axis(3, 0, 4));
    assertEquals(
        "direction is [0.0, 0.0, 0.0], must be finite and at least 0.001 long",
        refusal(() -> new Axis(0, 0, 0)));
    assertEquals(
        "direction is [NaN, 0.0, 1.0], must be finite and at least 0.001 long",
        refusal(() -> new Axis(Double.NaN, 0, 1)));
  }

  @Test
  void toolDirectionIsAConeThatRestricts() {
    Axis z = new Axis(0, 0, 1);
    assertEquals(
        "tool direction: largest angle is 4.0 rad, must be above 0 and below pi",
        refusal(() -> new ToolDirection(z, z, 4, Applies.BOTH)));
    assertEquals(
        "tool direction: applies is triggers_reduced, must be normal, reduced or both",
        refusal(() -> new ToolDirection(z, z, 1, Applies.TRIGGERS_REDUCED)));
  }

  @Test
  void codesAreThoseOfTheInterfaces() {
    assertEquals(-1, RobotMode.NO_CONTROLLER.code());
    assertEquals(7, RobotMode.RUNNING.code());
    assertEquals(8, RobotMode.UPDATING_FIRMWARE.code());
    assertEquals(1, SafetyMode.NORMAL.code());
    assertEquals(9, SafetyMode.FAULT.code());
    assertEquals(12, SafetyMode.AUTOMATIC_MODE_SAFEGUARD_STOP.code());
  }

  @Test
  void documentationListsEveryCode() throws Exception {
    String page = Files.readString(Path.of("../../docs/safety.md"));
    for (StopReason reason : StopReason.values()) {
      assertTrue(page.contains("| C" + reason.code() + " | "), reason::name);
    }
  }

  @Test
  void documentationListsEveryInput() throws Exception {
    String page = Files.readString(Path.of("../../docs/safety.md"));
    for (SafetyInput input : SafetyInput.values()) {
      assertTrue(page.contains("`" + input.word() + "`"), input::name);
    }
  }
}
