package org.pendant.controller.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.sensor.ArmSensors;
import org.pendant.controller.world.Scene;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

@Tag("slow")
class JointServosTest {

  static Stream<String> allArms() {
    return ArmLibrary.ids().stream();
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void heldArmWithTheRightPayloadDoesNotMoveByABit(String id) {
    Rig rig = new Rig(id);
    Payload payload = Rig.rated(rig.description, 1);
    rig.carrying(payload, payload);

    assertEquals(0, rig.worstWhileHolding(2000, Rig.START));
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void wrongPayloadSagsALittleAndIsPulledBack(String id) {
    Rig rig = new Rig(id);
    rig.carrying(Rig.rated(rig.description, 1), Rig.rated(rig.description, 0.5));

    double sag = rig.worstWhileHolding(1500, Rig.START);

    assertTrue(sag > 1e-4 && sag < 0.02, "sag is " + sag);
    assertTrue(rig.distance(Rig.START) < 1e-4, "stays off by " + rig.distance(Rig.START));
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void moveIsFollowedCloselyAndEndsInExactRest(String id) {
    ArmDescription description = ArmLibrary.load(id);
    for (double share : new double[] {0, 1}) {
      Rig rig = new Rig(id);
      Payload payload = Rig.rated(description, share);
      rig.carrying(payload, payload);

      double worst = rig.worstWhileMoving(Rig.START, Rig.ELSEWHERE);

      assertTrue(worst < 1e-4, "lags by " + worst);
      assertTrue(rig.framesToRest(Rig.ELSEWHERE) < 50);
      assertTrue(rig.distance(Rig.ELSEWHERE) < 1e-4);
      assertEquals(Joints.ZERO, rig.arm.speedRadPerS());
    }
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void drivesLagHalfAMillisecondBehindAndKeepNoneOfItAtRest(String id) {
    Rig rig = new Rig(id);
    Trapezoid move = new Trapezoid(Rig.START, Rig.ELSEWHERE, 1.4, 1.05);
    double lagTimesSpeed = 0;
    double speedSquared = 0;
    for (int frame = 1; frame <= move.frames(); frame++) {
      ArmCommand.Servo target = move.at(frame);
      rig.arm.step(target);
      for (int i = 0; i < Joints.COUNT; i++) {
        double lag = target.positionRad().get(i) - rig.arm.positionRad().get(i);
        lagTimesSpeed += lag * target.speedRadPerS().get(i);
        speedSquared += Math.pow(target.speedRadPerS().get(i), 2);
      }
    }
    assertEquals(0.00049, lagTimesSpeed / speedSquared, 0.00002);
    assertTrue(rig.worstWhileHolding(150, Rig.ELSEWHERE) < 1e-4);
    assertTrue(rig.worstWhileHolding(1000, Rig.ELSEWHERE) < 5e-5);
    assertTrue(rig.distance(Rig.ELSEWHERE) < 3e-5);
  }

  @Test
  void dryFrictionStaysLoadedAlongTheLastMotionAndDiffersAfterEveryStop() {
    Rig rig = new Rig("ur3e");
    List<Double> shares = new ArrayList<>();
    Joints from = Rig.START;
    for (int stop = 0; stop < 6; stop++) {
      Joints to = stop % 2 == 0 ? Rig.ELSEWHERE : Rig.START;
      rig.worstWhileMoving(from, to);
      rig.framesToRest(to);
      for (int i = 0; i < Joints.COUNT; i++) {
        ArmSensors sensors = rig.arm.sensors();
        double held = sensors.currentA().get(i) - sensors.targetCurrentA().get(i);
        double along = held * Math.signum(to.get(i) - from.get(i));
        double dry = rig.description.actuators().get(i).friction().dryA(20);
        assertTrue(along > 0.03 && along < dry, "joint " + i + " holds " + along + " A");
        shares.add(held);
      }
      from = to;
    }
    assertEquals(shares.size(), shares.stream().distinct().count());
  }

  @Test
  void whatStaysLoadedComesFromTheSeed() {
    assertEquals(heldAfterAMove(1), heldAfterAMove(1));
    assertNotEquals(heldAfterAMove(1), heldAfterAMove(2));
  }

  private static Joints heldAfterAMove(long seed) {
    Rig rig = new Rig("ur5e", seed);
    rig.worstWhileMoving(Rig.START, Rig.ELSEWHERE);
    rig.framesToRest(Rig.ELSEWHERE);
    return rig.arm.sensors().currentA();
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void moveWithAPayloadThatIsHalfWrongStaysNearItsPath(String id) {
    Rig rig = new Rig(id);
    rig.carrying(Rig.rated(rig.description, 1), Rig.rated(rig.description, 0.5));
    rig.framesToRest(Rig.START);

    double worst = rig.worstWhileMoving(Rig.START, Rig.ELSEWHERE);
    rig.framesToRest(Rig.ELSEWHERE);

    assertTrue(worst > 1e-4 && worst < 0.01, "lags by " + worst);
    assertTrue(rig.distance(Rig.ELSEWHERE) < 1e-4);
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void grosslyWrongPayloadsAreStable(String id) {
    for (double truth : new double[] {0, 1}) {
      Rig rig = new Rig(id);
      rig.carrying(Rig.rated(rig.description, truth), Rig.rated(rig.description, 1 - truth));

      double worst = rig.worstWhileMoving(Rig.START, Rig.ELSEWHERE);

      assertTrue(worst < 0.02, "lags by " + worst);
      rig.framesToRest(Rig.ELSEWHERE);
      assertTrue(rig.distance(Rig.ELSEWHERE) < 1e-4);
    }
  }

  @Test
  void driveWithoutFrictionComesToExactRest() {
    Rig rig = new Rig(Rig.frictionless(ArmLibrary.load("ur5e")), Scene.EMPTY);

    rig.worstWhileMoving(Rig.START, Rig.ELSEWHERE);

    assertTrue(rig.framesToRest(Rig.ELSEWHERE) < 500);
    assertTrue(rig.distance(Rig.ELSEWHERE) < 1e-4);
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur16e", "ur20"})
  void pushedArmYieldsVisiblyAndReturns(String id) {
    Wrench[] pushes = {
      new Wrench(50, 0, 0, 0, 0, 0), new Wrench(0, 50, 0, 0, 0, 0), new Wrench(0, 0, -50, 0, 0, 0)
    };
    for (Wrench push : pushes) {
      Rig rig = new Rig(id);
      rig.world.apply(push);

      double worst = rig.worstWhileHolding(1000, Rig.START);

      assertTrue(worst > 8e-5 && worst < 0.02, push + " moves it by " + worst);
      assertTrue(rig.distance(Rig.START) < 1e-4, push + " keeps it off");
      rig.world.release();
      assertTrue(rig.worstWhileHolding(1000, Rig.START) > 8e-5);
      assertTrue(rig.distance(Rig.START) < 1e-4);
    }
  }

  @ParameterizedTest
  @MethodSource("allArms")
  void targetThatJumpsIsReachedWithTheLargestTorqueAndSpeed(String id) {
    Rig rig = new Rig(id);
    Joints target = new Joints(0.5, -1.2, -1.2, -1.2, 2, 0.5);
    boolean saturated = false;
    for (int frame = 0; frame < 2000; frame++) {
      rig.arm.step(Rig.hold(target));
      for (int i = 0; i < Joints.COUNT; i++) {
        JointLimits limits = rig.description.joints().get(i);
        double torque = Math.abs(rig.arm.sensors().torqueNm().get(i));
        saturated |= torque == limits.maxTorqueNm();
        assertTrue(torque <= limits.maxTorqueNm(), "joint " + i + " gives " + torque + " Nm");
        double speed = Math.abs(rig.arm.speedRadPerS().get(i));
        assertTrue(speed < 1.25 * limits.maxSpeedRadPerS(), "joint " + i + " has " + speed);
      }
    }
    assertTrue(saturated);
    assertTrue(rig.distance(target) < 1e-4);
  }

  @Test
  void restingArmNoticesANewPayloadBelief() {
    Rig rig = new Rig("ur5e");
    rig.repeat(10, Rig.hold(Rig.START));
    rig.carrying(Payload.NONE, Payload.of(5, 0, 0, 0.1));

    assertTrue(rig.worstWhileHolding(200, Rig.START) > 1e-4);
  }
}
