package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

class IdealArmTest {
  private final IdealArm arm = new IdealArm(ArmLibrary.load("ur5e"), Rig.START);

  @Test
  void isWhereItsTargetIs() {
    Joints speed = new Joints(1, 0, 0, 0, 0, 0);
    Joints acceleration = new Joints(0, 2, 0, 0, 0, 0);

    arm.step(new ArmCommand.Servo(Rig.ELSEWHERE, speed, acceleration));

    assertEquals(Rig.ELSEWHERE, arm.positionRad());
    assertEquals(Rig.ELSEWHERE, arm.sensors().positionRad());
    assertEquals(speed, arm.speedRadPerS());
    assertEquals(acceleration, arm.sensors().accelerationRadPerS2());
    assertEquals(Joints.ZERO, arm.sensors().torqueNm());
    assertEquals(Joints.ZERO, arm.sensors().externalTorqueNm());
  }

  @Test
  void withoutATargetItStopsAtOnceAndStays() {
    arm.step(new ArmCommand.Servo(Rig.ELSEWHERE, new Joints(1, 1, 1, 1, 1, 1), Joints.ZERO));

    arm.step(ArmCommand.BRAKES_ON);
    arm.step(new ArmCommand.Torque(new Joints(9, 9, 9, 9, 9, 9), true));

    assertEquals(Rig.ELSEWHERE, arm.positionRad());
    assertEquals(Joints.ZERO, arm.speedRadPerS());
  }

  @Test
  void followsTheSameTargetAgainAfterAJump() {
    arm.step(Rig.hold(Rig.ELSEWHERE));
    arm.jumpTo(Rig.START);
    assertEquals(Rig.START, arm.positionRad());

    arm.step(Rig.hold(Rig.ELSEWHERE));

    assertEquals(Rig.ELSEWHERE, arm.positionRad());
  }

  @Test
  void accelerometerReadsGravityAsTheBaseIsMounted() {
    assertEquals(-9.82, arm.sensors().toolAccelerationMPerS2(2), 1e-9);

    arm.setMounting(0, 0, -9.82);

    assertEquals(9.82, arm.sensors().toolAccelerationMPerS2(2), 1e-9);
  }

  @Test
  void staysAtRoomTemperature() {
    arm.step(Rig.hold(Rig.ELSEWHERE));

    assertEquals(new Joints(25, 25, 25, 25, 25, 25), arm.sensors().temperatureC());
    assertEquals(25, arm.sensors().toolTemperatureC());
  }
}
