package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Wrench;
import org.pendant.models.pose.WrenchNumbers;

class ForceSensorTest {
  private static final Payload GRIPPER =
      new Payload(2, 0.01, -0.02, 0.08, 0.01, 0.02, 0.005, 0.001, 0, -0.002);

  private final ForceSensor sensor = new ForceSensor();

  private Wrench inBase(SimulatedArm arm, Payload declared) {
    WrenchNumbers wrench = new WrenchNumbers();
    sensor.readAtFlangeInBase(arm, declared, wrench);
    return wrench.wrench();
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur16e", "ur20"})
  void rightPayloadReadsNothingDuringAMove(String id) {
    Rig rig = new Rig(id).carrying(GRIPPER, GRIPPER);
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    for (int frame = 1; frame <= move.frames(); frame++) {
      rig.arm.step(move.at(frame));
      requireClose(Wrench.ZERO, inBase(rig.arm, GRIPPER), 1e-9);
    }
  }

  @Test
  void undeclaredKilogramHangsDownAtItsPlace() {
    Rig rig = new Rig("ur5e").carrying(Payload.of(1, 0.1, 0, 0), Payload.NONE);
    rig.framesToRest(Rig.START);

    Wrench reading = inBase(rig.arm, Payload.NONE);

    assertEquals(-9.82, reading.fz(), 0.01);
    assertEquals(9.82, Math.hypot(reading.fx(), Math.hypot(reading.fy(), reading.fz())), 0.01);
    assertEquals(0.982, Math.hypot(reading.mx(), reading.my()), 0.01);
  }

  @Test
  void pressingOnTheToolFromBelowReadsUpwards() {
    Rig rig = new Rig("ur5e").carrying(GRIPPER, GRIPPER);
    rig.arm.setToolCentre(new Pose(0, 0, 0.1, 0, 0, 0));
    rig.world.apply(new Wrench(10, 0, 30, 0, 0, 0));

    rig.repeat(2000, Rig.hold(Rig.START));

    // the flange points down: the tool centre is 0.1 m below it
    requireClose(new Wrench(10, 0, 30, 0, -1, 0), inBase(rig.arm, GRIPPER), 1e-2);
  }

  @Test
  void zeroTakesAwayWhatIsThereNow() {
    Rig rig = new Rig("ur5e").carrying(GRIPPER, Payload.NONE);
    rig.framesToRest(Rig.START);

    sensor.zero(rig.arm, Payload.NONE);

    requireClose(Wrench.ZERO, sensor.reading(rig.arm, Payload.NONE), 0);
  }

  @Test
  void zeroTurnsWithTheFlange() {
    Rig rig = new Rig("ur5e").carrying(Payload.of(1, 0, 0, 0), Payload.NONE);
    rig.framesToRest(Rig.START);
    sensor.zero(rig.arm, Payload.NONE);
    Joints upsideDown = Rig.START.with(3, Math.PI / 2);
    rig.worstWhileMoving(Rig.START, upsideDown);
    rig.framesToRest(upsideDown);

    assertEquals(-2 * 9.82, inBase(rig.arm, Payload.NONE).fz(), 0.01);
  }

  @Test
  void idealArmFeelsOnlyWhatNobodyHasDeclared() {
    IdealArm arm = new IdealArm(ArmLibrary.load("ur5e"), Rig.START);
    arm.setLoad(Payload.of(3, 0, 0, 0.1));
    arm.step(Rig.hold(Rig.ELSEWHERE));

    requireClose(Wrench.ZERO, inBase(arm, Payload.of(3, 0, 0, 0.1)), 1e-12);
    assertEquals(-9.82, inBase(arm, Payload.of(2, 0, 0, 0.1)).fz(), 1e-9);
  }

  private static void requireClose(Wrench expected, Wrench found, double tolerance) {
    assertEquals(expected.fx(), found.fx(), tolerance);
    assertEquals(expected.fy(), found.fy(), tolerance);
    assertEquals(expected.fz(), found.fz(), tolerance);
    assertEquals(expected.mx(), found.mx(), tolerance);
    assertEquals(expected.my(), found.my(), tolerance);
    assertEquals(expected.mz(), found.mz(), tolerance);
  }
}
