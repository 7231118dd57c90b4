package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.sensor.ArmSensors;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

class DynamicArmTest {

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur16e", "ur20"})
  void brakesStopEachJointEvenlyAndLockIt(String id) {
    Rig rig = new Rig(id);
    Trapezoid move = new Trapezoid(Rig.START, new Joints(1.6, -0.1, -0.1, -0.1, 3, 1.5), 3, 1);
    for (int frame = 1; frame <= move.frames() / 2; frame++) {
      rig.arm.step(move.at(frame));
    }
    Joints where = rig.arm.positionRad();
    double speed = rig.arm.speedRadPerS().q0();
    assertEquals(1, speed, 0.01);

    rig.repeat((int) Math.ceil(speed / 30 / 0.002), ArmCommand.BRAKES_ON);

    assertEquals(Joints.ZERO, rig.arm.speedRadPerS());
    assertEquals(speed * speed / (2 * 30), rig.distance(where), 1e-4);
    Joints locked = rig.arm.positionRad();
    rig.world.apply(new Wrench(0, 0, 500, 0, 0, 0));
    rig.repeat(500, ArmCommand.BRAKES_ON);
    assertEquals(locked, rig.arm.positionRad());
    assertEquals(Joints.ZERO, rig.arm.sensors().torqueNm());
    assertEquals(Joints.ZERO, rig.arm.sensors().externalTorqueNm());
    assertEquals(Joints.ZERO, rig.arm.sensors().currentA());
  }

  @Test
  void sameCommandsAndSeedGiveTheSameReadingsToTheLastBit() {
    assertEquals(readings(noisy(5)), readings(noisy(5)));
    assertNotEquals(readings(noisy(5)), readings(noisy(6)));
  }

  @Test
  void encoderNoiseShowsInTheReadingsButMovesNothing() {
    DynamicArm arm = noisy(1);
    List<Joints> readings = readings(arm);
    double sum = 0;
    for (Joints reading : readings) {
      sum += reading.squaredDistance(Rig.START) / Joints.COUNT;
    }
    assertEquals(1e-5, Math.sqrt(sum / readings.size()), 1e-6);
    assertEquals(Joints.ZERO, arm.speedRadPerS());
  }

  @Test
  void negativeNoiseIsRefused() {
    IllegalArgumentException refused =
        assertThrows(
            IllegalArgumentException.class, () -> ReadingNoise.MEASURED.withPosition(-1e-5));
    assertEquals("encoder noise is -1.0E-5 rad, must be at least 0", refused.getMessage());
  }

  @Test
  void freeMotionShowsNoTorqueFromOutside() {
    Rig rig = new Rig("ur5e");
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    for (int frame = 1; frame < move.frames(); frame++) {
      rig.arm.step(move.at(frame));
      assertTrue(
          rig.arm.sensors().externalTorqueNm().maxAbsDifference(Joints.ZERO) < 0.5,
          "frame " + frame + ": " + rig.arm.sensors().externalTorqueNm());
    }
  }

  @Test
  void pushShowsAsTorqueFromOutside() {
    Rig rig = new Rig("ur5e");
    rig.world.apply(new Wrench(0, 80, 0, 0, 0, 0));

    rig.repeat(2000, Rig.hold(Rig.START));

    double[] flange = new double[12];
    rig.arm.copyFlangeInBase(flange);
    double pushedNm = 80 * flange[9];
    double frictionNm = rig.description.actuators().get(0).dryNm(0);
    assertEquals(-pushedNm, rig.arm.sensors().externalTorqueNm(0), frictionNm);
  }

  @Test
  void currentsAreTorquesOverTheConstantOfTheDrive() {
    Rig rig = new Rig("ur5e");

    rig.repeat(5, Rig.hold(Rig.START));

    ArmSensors sensors = rig.arm.sensors();
    double shoulderNm = sensors.torqueNm().q1();
    double constant = rig.description.actuators().get(1).torqueConstantNmPerA();
    assertTrue(Math.abs(shoulderNm) > 10);
    assertEquals(shoulderNm / constant, sensors.currentA().q1(), 1e-12);
    assertEquals(sensors.targetTorqueNm().q1(), shoulderNm, 1e-9);
    assertEquals(sensors.targetCurrentA().q1(), sensors.currentA().q1(), 1e-9);
  }

  @Test
  void accelerometerReadsGravityUpwards() {
    Rig rig = new Rig("ur5e"); // the flange's z axis points down
    rig.repeat(2, Rig.hold(Rig.START));
    assertEquals(-9.82, rig.arm.sensors().toolAccelerationMPerS2(2), 1e-9);

    rig.arm.setMounting(0, 0, -9.82);

    assertEquals(9.82, rig.arm.sensors().toolAccelerationMPerS2(2), 1e-9);
  }

  @Test
  void accelerometerFeelsTheMotion() {
    Rig rig = new Rig("ur5e");
    rig.arm.step(Rig.hold(Rig.START));
    double[] flange = new double[12];
    rig.arm.copyFlangeInBase(flange);
    Trapezoid turn = new Trapezoid(Rig.START, Rig.START.with(0, 1), 2, 1);

    rig.arm.step(turn.at(1));
    rig.arm.step(turn.at(2)); // the drives lag behind: in the first frame they are slower

    double horizontal =
        Math.hypot(
            rig.arm.sensors().toolAccelerationMPerS2(0),
            rig.arm.sensors().toolAccelerationMPerS2(1));
    assertEquals(2 * Math.hypot(flange[9], flange[10]), horizontal, 0.02);
  }

  @Test
  void loadedJointsWarmUpMoreThanIdleOnesAndWithinReason() {
    Rig rig = new Rig("ur5e");
    Payload payload = Rig.rated(rig.description, 1);
    rig.carrying(payload, payload);
    assertEquals(25, rig.arm.sensors().temperatureC().q1());

    rig.repeat(500 * 3600, Rig.hold(Rig.START));

    Joints warm = rig.arm.sensors().temperatureC();
    assertTrue(warm.q1() > warm.q0() + 1, warm.toString());
    for (int i = 0; i < Joints.COUNT; i++) {
      assertTrue(warm.get(i) > 27 && warm.get(i) < 45, warm.toString());
    }
    assertEquals(29.8, rig.arm.sensors().toolTemperatureC(), 0.1);
  }

  @Test
  void jumpPutsTheArmElsewhereAtRest() {
    Rig rig = new Rig("ur5e");
    rig.worstWhileMoving(Rig.START, Rig.ELSEWHERE);

    rig.arm.jumpTo(Rig.START);

    assertEquals(Rig.START, rig.arm.positionRad());
    assertEquals(Joints.ZERO, rig.arm.speedRadPerS());
    assertEquals(0, rig.worstWhileHolding(100, Rig.START));
  }

  @Test
  void tiltedBaseThatTheControllerKnowsOfChangesNothing() {
    Rig rig = new Rig("ur5e");
    rig.arm.setMounting(9.82, 0, 0);
    rig.model.setGravity(9.82, 0, 0);
    rig.arm.modelChanged();

    assertEquals(0, rig.worstWhileHolding(200, Rig.START));
  }

  @Test
  void tiltedBaseThatTheControllerDoesNotKnowOfShows() {
    Rig rig = new Rig("ur5e");
    rig.arm.setMounting(9.82, 0, 0);

    assertTrue(rig.worstWhileHolding(200, Rig.START) > 1e-4);
  }

  private static DynamicArm noisy(long seed) {
    ArmDescription description = ArmLibrary.load("ur5e");
    return new DynamicArm(
        new DynamicArm.Setup(
            description,
            Rig.START,
            new ArmDynamics(description),
            new ContactWorld(Scene.EMPTY),
            ReadingNoise.NONE.withPosition(1e-5),
            seed));
  }

  private static List<Joints> readings(DynamicArm arm) {
    List<Joints> readings = new ArrayList<>();
    for (int frame = 0; frame < 1000; frame++) {
      arm.step(Rig.hold(Rig.START));
      readings.add(arm.positionRad());
    }
    return readings;
  }
}
