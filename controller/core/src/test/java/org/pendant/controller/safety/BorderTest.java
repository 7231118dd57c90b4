package org.pendant.controller.safety;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Pose;

/** Joint ranges, planes and tool direction. */
final class BorderTest {
  private static final SafetyConfiguration STANDARD = SafetyBench.standardOfUr5e();
  private static final double RANGE = 2 * Math.PI + Math.toRadians(3);

  private static Pose flange(SafetyBench bench) {
    return new ForwardKinematics(bench.arm).flangePose(SafetyBench.START);
  }

  /** Keeps the tool above a height. */
  private static SafetyPlane floor(double heightM, Applies applies, boolean elbow) {
    return new SafetyPlane("floor", 0, 0, heightM, new Axis(0, 0, 2), applies, elbow);
  }

  private static SafetyBench above(double heightM, boolean elbow) {
    return SafetyBench.with(STANDARD.withPlanes(floor(heightM, Applies.BOTH, elbow))).program(true);
  }

  private static double startHeightM() {
    return flange(SafetyBench.standard()).z();
  }

  @Test
  void jointStopsWhileItStillCanBeforeItsLimit() {
    double speed = 2;
    double travel = speed * speed / 2 / 15;
    SafetyBench bench = SafetyBench.standard();
    Joints before = SafetyBench.START.with(4, RANGE - travel - 1e-4);
    bench.target(before, SafetyBench.speed(4, speed)).arm(before, Joints.ZERO).step();
    assertTrue(bench.safety.stop().isEmpty());
    Joints after = SafetyBench.START.with(4, RANGE - travel + 1e-4);
    bench.target(after, SafetyBench.speed(4, speed)).arm(after, Joints.ZERO);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(
        "C150A4 protective stop at 0.004 s: wrist 2 (joint 4) comes too close to its position"
            + " limit: 6.3356 rad, limit 6.3355 rad",
        bench.stop().message());
  }

  @Test
  void jointStopsBeforeItsLowerLimit() {
    SafetyBench bench = SafetyBench.standard();
    Joints q = SafetyBench.START.with(0, -RANGE + 0.01);
    bench.target(q, SafetyBench.speed(0, -2)).arm(q, Joints.ZERO);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(-RANGE, bench.stop().limit(), 1e-12);
  }

  @Test
  void jointMayMoveAwayFromItsLimit() {
    SafetyBench bench = SafetyBench.standard();
    Joints q = SafetyBench.START.with(4, RANGE);
    bench.target(q, SafetyBench.speed(4, -2)).arm(q, Joints.ZERO);
    assertEquals(SafetyAction.NONE, bench.step());
  }

  /** The height of the tool falls at this rate when the elbow turns, m/rad. */
  private static double fallPerElbowTurn(SafetyBench bench) {
    ArmPoints points = new ArmPoints(bench.arm);
    points.at(SafetyBench.START.toArray(), SafetyBench.speed(2, 1).toArray(), Pose.ZERO);
    return points.toolVelocity(2);
  }

  @Test
  void toolStopsWhileItStillCanBeforeAPlane() {
    double fall = fallPerElbowTurn(SafetyBench.standard());
    double speed = -Math.signum(fall) * 0.5;
    double travel = Math.abs(fall) * 0.5 * 0.5 / 2 / 15;
    SafetyBench free = above(startHeightM() - travel - 1e-4, false);
    free.target(SafetyBench.START, SafetyBench.speed(2, speed)).step();
    assertTrue(free.safety.stop().isEmpty());
    SafetyBench late = above(startHeightM() - travel + 1e-4, false);
    late.target(SafetyBench.START, SafetyBench.speed(2, speed));
    assertEquals(SafetyAction.STOP_ON_PATH, late.step());
    assertEquals(
        "C152A0 protective stop at 0.002 s: tool comes too close to safety plane \"floor\":"
            + " -0.0001 m, limit 0 m",
        late.stop().message());
    SafetyBench away = above(startHeightM() - travel + 1e-4, false);
    away.target(SafetyBench.START, SafetyBench.speed(2, -speed));
    assertEquals(SafetyAction.NONE, away.step());
  }

  @Test
  void toolBeyondAPlaneByMoreThanFourCentimetresIsAViolation() {
    SafetyBench inside = above(startHeightM() + 0.039, false);
    assertEquals(SafetyAction.NONE, inside.step());
    SafetyBench beyond = above(startHeightM() + 0.041, false);
    assertEquals(SafetyAction.OFF_NOW, beyond.step());
    assertEquals(
        "C191A8 violation at 0.002 s: tool is beyond safety plane \"floor\": -0.041 m, limit 0 m",
        beyond.stop().message());
  }

  @Test
  void elbowCountsWhenItIsMeant() {
    // at the start the elbow stands 0.5875 m high, above the tool
    SafetyPlane ceiling =
        new SafetyPlane("ceiling", 0, 0, 0.54, new Axis(0, 0, -1), Applies.BOTH, true);
    SafetyBench bench = SafetyBench.with(STANDARD.withPlanes(ceiling)).program(true);
    assertEquals(SafetyAction.OFF_NOW, bench.step());
    assertTrue(bench.stop().message().contains("elbow is beyond safety plane \"ceiling\""));
    SafetyPlane forTheTool =
        new SafetyPlane("ceiling", 0, 0, 0.54, new Axis(0, 0, -1), Applies.BOTH, false);
    assertEquals(
        SafetyAction.NONE, SafetyBench.with(STANDARD.withPlanes(forTheTool)).program(true).step());
  }

  @Test
  void elbowStopsBeforeAPlane() {
    SafetyPlane wall = new SafetyPlane("wall", 0.01, 0, 0, new Axis(-1, 0, 0), Applies.BOTH, true);
    SafetyBench bench = SafetyBench.with(STANDARD.withPlanes(wall));
    // the tool is beyond the wall; only the elbow, over the base, matters to the stop
    Joints turned = SafetyBench.START.with(0, Math.PI);
    ArmPoints points = new ArmPoints(bench.arm);
    points.at(turned.toArray(), SafetyBench.speed(1, 1).toArray(), Pose.ZERO);
    double speed = Math.signum(points.elbowVelocity(0));
    Observation seen = new Observation(bench.arm, new ArmDynamics(bench.arm), true);
    FrameFacts facts = bench.target(turned, SafetyBench.speed(1, speed)).facts();
    seen.take(facts);
    seen.evaluate(facts);
    TravelCheck check = new TravelCheck(STANDARD.withPlanes(wall));
    SafetyStop stop = check.check(0, seen, STANDARD.normal(), false).orElseThrow();
    assertTrue(stop.message().contains("elbow comes too close"), stop.message());
  }

  @Test
  void planeOfTheReducedModeLeavesTheNormalModeAlone() {
    SafetyBench bench =
        SafetyBench.with(STANDARD.withPlanes(floor(startHeightM() + 0.1, Applies.REDUCED, false)))
            .program(true);
    assertEquals(SafetyAction.NONE, bench.step());
    bench.safety.setInput(SafetyInput.REDUCED_MODE, true);
    assertEquals(251, bench.stepsUntilAction(1000));
    assertEquals("C191A8", bench.stop().codeText());
  }

  @Test
  void planeOfTheNormalModeLeavesTheReducedModeAlone() {
    SafetyBench bench =
        SafetyBench.with(STANDARD.withPlanes(floor(startHeightM() + 0.1, Applies.NORMAL, false)))
            .program(true);
    assertEquals(SafetyAction.OFF_NOW, bench.step());
  }

  private static ToolDirection down(double largestAngleRad) {
    return new ToolDirection(new Axis(0, 0, -1), new Axis(0, 0, 1), largestAngleRad, Applies.BOTH);
  }

  @Test
  void toolStopsWhileItStillCanBeforeItsLargestTilt() {
    SafetyBench bench = SafetyBench.with(STANDARD.withToolDirection(down(0.5)));
    double speed = 1;
    double travel = speed * speed / 2 / 15;
    Joints before = SafetyBench.START.with(3, SafetyBench.START.q3() - 0.5 + travel + 1e-4);
    bench.target(before, SafetyBench.speed(3, -speed)).arm(before, Joints.ZERO).step();
    assertTrue(bench.safety.stop().isEmpty());
    Joints after = SafetyBench.START.with(3, SafetyBench.START.q3() - 0.5 + travel - 1e-4);
    bench.target(after, SafetyBench.speed(3, -speed)).arm(after, Joints.ZERO);
    assertEquals(SafetyAction.STOP_ON_PATH, bench.step());
    assertEquals(
        "C151A0 protective stop at 0.004 s: tool comes too close to its largest tilt: 0.5001 rad,"
            + " limit 0.5 rad",
        bench.stop().message());
  }

  @Test
  void toolMayTiltBack() {
    SafetyBench bench = SafetyBench.with(STANDARD.withToolDirection(down(0.5)));
    Joints tilted = SafetyBench.START.with(3, SafetyBench.START.q3() - 0.5);
    bench.target(tilted, SafetyBench.speed(3, 1)).arm(tilted, Joints.ZERO);
    assertEquals(SafetyAction.NONE, bench.step());
  }

  @Test
  void toolTiltedByMoreThanThreeDegreesTooFarIsAViolation() {
    SafetyBench bench = SafetyBench.with(STANDARD.withToolDirection(down(0.5))).program(true);
    double q3 = SafetyBench.START.q3();
    bench.at(SafetyBench.START.with(3, q3 + 0.5 + Math.toRadians(2.9))).step();
    assertTrue(bench.safety.stop().isEmpty());
    bench.at(SafetyBench.START.with(3, q3 + 0.5 + Math.toRadians(3.1)));
    assertEquals(SafetyAction.OFF_NOW, bench.step());
    assertEquals("C191A9", bench.stop().codeText());
  }

  @Test
  void withinAsksForRangesPlanesAndDirection() {
    SafetyConfiguration configuration =
        STANDARD
            .withPlanes(floor(0.1, Applies.BOTH, false), floor2(Applies.REDUCED))
            .withToolDirection(down(0.5));
    SafetySystem safety = SafetyBench.with(configuration).safety;
    assertTrue(safety.within(SafetyBench.START, Pose.ZERO));
    assertFalse(safety.within(SafetyBench.START.with(5, RANGE + 0.01), Pose.ZERO));
    assertTrue(safety.within(SafetyBench.START.with(5, RANGE - 0.01), Pose.ZERO));
    assertFalse(safety.within(SafetyBench.START.with(3, SafetyBench.START.q3() + 0.51), Pose.ZERO));
    double reach = startHeightM() - 0.1;
    assertTrue(safety.within(SafetyBench.START, new Pose(0, 0, reach - 0.001, 0, 0, 0)));
    assertFalse(safety.within(SafetyBench.START, new Pose(0, 0, reach + 0.001, 0, 0, 0)));
  }

  private static SafetyPlane floor2(Applies applies) {
    return new SafetyPlane("shelf", 0, 0, 5, new Axis(0, 0, 1), applies, false);
  }

  @Test
  void withinFollowsTheReducedMode() {
    SafetyBench bench = SafetyBench.with(STANDARD.withPlanes(floor2(Applies.REDUCED)));
    assertTrue(bench.safety.within(SafetyBench.START, Pose.ZERO));
    bench.safety.setInput(SafetyInput.REDUCED_MODE, true);
    bench.step();
    assertFalse(bench.safety.within(SafetyBench.START, Pose.ZERO));
  }

  @Test
  void aStopTellsWhichBorderItIsAbout() {
    SafetyBench plane = above(startHeightM() + 0.041, false);
    plane.step();
    assertEquals(Optional.of("floor"), plane.stop().plane());
    assertFalse(plane.stop().aboutToolDirection());

    SafetyBench tilt = SafetyBench.with(STANDARD.withToolDirection(down(0.5))).program(true);
    tilt.at(SafetyBench.START.with(3, SafetyBench.START.q3() + 0.6)).step();
    assertTrue(tilt.stop().aboutToolDirection());
    assertEquals(OptionalInt.empty(), tilt.stop().jointAtItsLimit());

    SafetyBench joint = SafetyBench.standard();
    Joints q = SafetyBench.START.with(4, RANGE - 0.01);
    joint.target(q, SafetyBench.speed(4, 2)).arm(q, Joints.ZERO).step();
    assertEquals(OptionalInt.of(4), joint.stop().jointAtItsLimit());
    assertEquals(Optional.empty(), joint.stop().plane());
  }

  @Test
  void aPlaneNearIsNamedByItsStop() {
    double fall = fallPerElbowTurn(SafetyBench.standard());
    SafetyBench late = above(startHeightM(), false);
    late.target(SafetyBench.START, SafetyBench.speed(2, -Math.signum(fall))).step();
    assertEquals(152, late.stop().code());
    assertEquals(Optional.of("floor"), late.stop().plane());
  }
}
