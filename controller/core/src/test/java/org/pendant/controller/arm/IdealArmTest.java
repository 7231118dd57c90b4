package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.pendant.controller.world.ContactWorld;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.motion.servo.FrictionShare;

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
  void tellsWhatItsTargetWouldNeedByTheControllersModel() {
    DynamicArm dynamic = new Rig("ur5e").arm;
    Joints speed = new Joints(1, 0, 0, 0, 0, 0);
    ArmCommand target = new ArmCommand.Servo(Rig.START, speed, new Joints(0, 2, 0, 0, 0, 0));

    arm.step(target);
    dynamic.step(target);

    assertTrue(arm.sensors().targetTorqueNm().q1() > 20);
    assertEquals(dynamic.sensors().targetTorqueNm(), arm.sensors().targetTorqueNm());
    assertEquals(dynamic.sensors().targetCurrentA(), arm.sensors().targetCurrentA());
    arm.step(ArmCommand.BRAKES_ON);
    assertEquals(Joints.ZERO, arm.sensors().targetTorqueNm());
    assertEquals(Joints.ZERO, arm.sensors().targetCurrentA());
  }

  @Test
  void withoutATargetItStopsAtOnceAndStays() {
    arm.step(new ArmCommand.Servo(Rig.ELSEWHERE, new Joints(1, 1, 1, 1, 1, 1), Joints.ZERO));

    arm.step(ArmCommand.BRAKES_ON);

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

  @Test
  void guidedItYieldsAsTheDynamicArmDoes() {
    ArmDescription ur5e = ArmLibrary.load("ur5e");
    ContactWorld world = new ContactWorld(Scene.EMPTY);
    DynamicArm.Setup setup =
        new DynamicArm.Setup(ur5e, Rig.START, new ArmDynamics(ur5e), world, ReadingNoise.NONE, 0);
    IdealArm ideal = new IdealArm(setup);
    DynamicArm dynamic = new DynamicArm(setup);
    ArmCommand guide = new ArmCommand.Guide(Joints.ZERO, new Joints(9, 9, 9, 3, 3, 3));
    world.grip().push(5, new Vector3(0, 0, 0), new Vector3(10, 20, 30));
    for (int frame = 0; frame < 200; frame++) {
      ideal.step(guide);
      dynamic.step(guide);
    }
    assertEquals(dynamic.positionRad(), ideal.positionRad());
    assertEquals(dynamic.speedRadPerS(), ideal.speedRadPerS());
    assertTrue(ideal.positionRad().maxAbsDifference(Rig.START) > 0.05);
  }

  @Test
  void torquesMoveItAsTheDynamicArm() {
    ArmDescription ur5e = ArmLibrary.load("ur5e");
    ContactWorld world = new ContactWorld(Scene.EMPTY);
    DynamicArm.Setup setup =
        new DynamicArm.Setup(ur5e, Rig.START, new ArmDynamics(ur5e), world, ReadingNoise.NONE, 0);
    IdealArm ideal = new IdealArm(setup);
    DynamicArm dynamic = new DynamicArm(setup);
    for (int frame = 0; frame < 100; frame++) {
      ArmCommand torque = new ArmCommand.Torque(Joints.ZERO.with(5, 2), FrictionShare.MOST);
      ideal.step(torque);
      dynamic.step(torque);
    }
    assertEquals(dynamic.positionRad(), ideal.positionRad());
    assertTrue(ideal.speedRadPerS().q5() > 0.1);
  }

  @Test
  void aHandTakesItOverAsItMoves() {
    Joints speed = new Joints(1, 0, 0, 0, 0, 0);
    arm.step(new ArmCommand.Servo(Rig.ELSEWHERE, speed, Joints.ZERO));
    arm.step(new ArmCommand.Guide(Joints.ZERO, Joints.ZERO));
    assertTrue(arm.positionRad().q0() > Rig.ELSEWHERE.q0());
    assertEquals(1, arm.speedRadPerS().q0(), 0.1);
    arm.step(Rig.hold(Rig.ELSEWHERE));
    assertEquals(Rig.ELSEWHERE, arm.positionRad());
  }
}
