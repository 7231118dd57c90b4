package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.motion.servo.FrictionShare;

class FreeMotorsTest {
  private static final ArmCommand FREE = new ArmCommand.Torque(Joints.ZERO, FrictionShare.MOST);

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur16e", "ur20"})
  void armWithoutFrictionKeepsItsKineticEnergyWhileItsWeightIsHeld(String id) {
    ArmDescription description = Rig.frictionless(ArmLibrary.load(id));
    Rig rig = new Rig(description, Scene.EMPTY);
    rig.repeat(100, new ArmCommand.Torque(kick(description), FrictionShare.NONE));
    ArmDynamics truth = new ArmDynamics(description);
    double energyJ = rig.kineticEnergyJ(truth);

    for (int frame = 0; frame < 500; frame++) {
      rig.arm.step(new ArmCommand.Torque(Joints.ZERO, FrictionShare.NONE));
      assertEquals(energyJ, rig.kineticEnergyJ(truth), 0.001 * energyJ);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur16e", "ur20"})
  void fallingArmTurnsHeightIntoSpeed(String id) {
    ArmDescription description = Rig.frictionless(ArmLibrary.load(id));
    Rig rig = new Rig(description, Scene.EMPTY);
    rig.model.setGravity(0, 0, 0); // the motors believe that nothing has to be held
    ArmDynamics truth = new ArmDynamics(description);
    double startJ = truth.potentialEnergyJ(Rig.START.toArray());
    double most = 0;
    for (int frame = 0; frame < 500; frame++) {
      rig.arm.step(new ArmCommand.Torque(Joints.ZERO, FrictionShare.NONE));
      double kinetic = rig.kineticEnergyJ(truth);
      most = Math.max(most, kinetic);
      double sum = kinetic + truth.potentialEnergyJ(rig.arm.positionRad().toArray());
      assertEquals(startJ, sum, 0.01 * most + 1e-6);
    }
    assertTrue(most > 5, "it falls by " + most + " J only");
  }

  @Test
  void freeArmStaysWhereItIs() {
    Rig rig = new Rig("ur5e");

    rig.repeat(5000, FREE);

    assertEquals(Rig.START, rig.arm.positionRad());
  }

  @Test
  void freeArmSinksUnderALoadThatNobodyHasDeclared() {
    Rig rig = new Rig("ur5e").carrying(Payload.of(2, 0, 0, 0.1), Payload.NONE);
    double before = flangeHeightM(rig);

    rig.repeat(250, FREE);

    assertTrue(flangeHeightM(rig) < before - 0.05);
  }

  @Test
  void frictionBrakesAMovingFreeArmEvenWhenItIsCompensated() {
    Rig rig = new Rig("ur5e");
    rig.repeat(50, new ArmCommand.Torque(new Joints(20, 0, 0, 0, 0, 0), FrictionShare.MOST));
    double speed = rig.arm.speedRadPerS().q0();
    assertTrue(speed > 0.05);

    rig.repeat(50, FREE);
    double later = rig.arm.speedRadPerS().q0();
    rig.repeat(2500, FREE);

    assertTrue(later < speed && later > 0.5 * speed, "from " + speed + " to " + later);
    assertEquals(Joints.ZERO, rig.arm.speedRadPerS());
  }

  @Test
  void constantTorqueAcceleratesTheLastJointByItsInertia() {
    ArmDescription description = Rig.frictionless(ArmLibrary.load("ur5e"));
    Rig rig = new Rig(description, Scene.EMPTY);
    DMatrixRMaj mass = new DMatrixRMaj(Joints.COUNT, Joints.COUNT);
    rig.model.mass(Rig.START.toArray(), true, mass);

    rig.arm.step(new ArmCommand.Torque(new Joints(0, 0, 0, 0, 0, 0.5), FrictionShare.NONE));

    double expected = 0.5 / mass.get(5, 5);
    assertEquals(expected, rig.arm.sensors().accelerationRadPerS2().q5(), 0.01 * expected);
  }

  @Test
  void servosTakeOverAMovingArm() {
    Rig rig = new Rig("ur5e");
    rig.repeat(100, new ArmCommand.Torque(new Joints(20, 0, 0, 0, 0, 0), FrictionShare.MOST));
    Joints here = rig.arm.positionRad();

    rig.framesToRest(here);

    assertTrue(rig.distance(here) < 1e-4);
  }

  private static Joints kick(ArmDescription description) {
    double[] torque = new double[Joints.COUNT];
    for (int i = 0; i < Joints.COUNT; i++) {
      torque[i] = (i % 2 == 0 ? 0.1 : -0.1) * description.joints().get(i).maxTorqueNm();
    }
    return Joints.of(torque);
  }

  private static double flangeHeightM(Rig rig) {
    double[] flange = new double[12];
    rig.arm.copyFlangeInBase(flange);
    return flange[11];
  }
}
