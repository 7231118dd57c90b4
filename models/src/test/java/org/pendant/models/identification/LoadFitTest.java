package org.pendant.models.identification;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Gravity;
import org.pendant.models.dynamics.Payload;

class LoadFitTest {
  private static final int SAMPLES = 200;

  /** Rotors of the arm that was recorded, of those described. */
  private static final double HEAVIER = 1.3;

  private static Joints vector(double amplitude, double phase, double t) {
    double[] values = new double[Joints.COUNT];
    for (int i = 0; i < values.length; i++) {
      values[i] = amplitude * Math.sin((1 + 0.3 * i) * t + phase + i);
    }
    return Joints.of(values);
  }

  /** What an arm with heavier rotors needs while all joints swing. */
  private static List<ArmSample> swinging(ArmDescription arm, Payload payload) {
    ArmDynamics dynamics = new ArmDynamics(arm);
    dynamics.setPayload(payload);
    List<ArmSample> samples = new ArrayList<>();
    for (int k = 0; k < SAMPLES; k++) {
      double t = 0.05 * k;
      Joints q = vector(1, 0, t);
      Joints qd = vector(0.8, 0.4, t);
      Joints qdd = vector(1.5, 1, t);
      double[] torque = new double[Joints.COUNT];
      dynamics.inverse(q.toArray(), qd.toArray(), qdd.toArray(), torque);
      for (int i = 0; i < torque.length; i++) {
        torque[i] += HEAVIER * arm.actuators().get(i).rotorInertiaKgM2() * qdd.get(i);
      }
      samples.add(new ArmSample(q, qd, qdd, Joints.of(torque)));
    }
    return samples;
  }

  private static List<ArmSample> resting(ArmDescription arm, Payload payload) {
    ArmDynamics dynamics = new ArmDynamics(arm);
    dynamics.setPayload(payload);
    Joints q = new Joints(0, -1, 1, -1, -1.5, 0);
    double[] torque = new double[Joints.COUNT];
    dynamics.gravity(q.toArray(), torque);
    ArmSample sample = new ArmSample(q, Joints.ZERO, Joints.ZERO, Joints.of(torque));
    return Collections.nCopies(SAMPLES, sample);
  }

  private static LoadFit.Found found(LoadFit fit) {
    return assertInstanceOf(LoadFit.Found.class, fit);
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur10e", "ur30"})
  void findsPayloadAndRotorsOfASwingingArm(String id) {
    ArmDescription arm = ArmLibrary.load(id);
    Payload payload = Payload.of(1.7, 0.03, -0.05, 0.11);

    LoadFit.Found found =
        found(
            LoadFit.of(
                arm, Gravity.UPRIGHT, swinging(arm, payload), Optional.empty(), Payload.NONE));

    assertEquals(1.7, found.payload().massKg(), 1e-4);
    assertEquals(0.03, found.payload().cogXM(), 1e-4);
    assertEquals(-0.05, found.payload().cogYM(), 1e-4);
    assertEquals(0.11, found.payload().cogZM(), 1e-4);
    for (int i = 0; i < Joints.COUNT; i++) {
      assertEquals(
          HEAVIER * arm.actuators().get(i).rotorInertiaKgM2(),
          found.rotorInertiaKgM2().get(i).orElseThrow(),
          1e-3,
          "joint " + i);
    }
    assertTrue(found.rmsBeforeNm() > 0.1, "the payload was not known before");
    assertEquals(0, found.rmsAfterNm(), 1e-3);
  }

  @Test
  void anArmWithoutPayloadIsFoundToHaveNone() {
    ArmDescription arm = ArmLibrary.load("ur5e");

    LoadFit.Found found =
        found(
            LoadFit.of(
                arm, Gravity.UPRIGHT, swinging(arm, Payload.NONE), Optional.empty(), Payload.NONE));

    assertEquals(Payload.NONE, found.payload());
  }

  @Test
  void aPayloadThatIsGivenStaysAndRotorsAreFound() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    Payload payload = Payload.of(2, 0, 0, 0.05);

    LoadFit.Found found =
        found(
            LoadFit.of(
                arm, Gravity.UPRIGHT, swinging(arm, payload), Optional.of(payload), Payload.NONE));

    assertEquals(payload, found.payload());
    assertEquals(
        HEAVIER * arm.actuators().get(2).rotorInertiaKgM2(),
        found.rotorInertiaKgM2().get(2).orElseThrow(),
        1e-6);
  }

  @Test
  void onePostureTellsNoPayload() {
    ArmDescription arm = ArmLibrary.load("ur5e");

    LoadFit.Refused refused =
        assertInstanceOf(
            LoadFit.Refused.class,
            LoadFit.of(
                arm,
                Gravity.UPRIGHT,
                resting(arm, Payload.of(1, 0, 0, 0)),
                Optional.empty(),
                Payload.NONE));

    assertEquals(
        "the postures do not tell the payload, must turn the tool against gravity",
        refused.reason());
  }

  @Test
  void aJointThatIsNotAcceleratedKeepsItsRotor() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    List<ArmSample> still = new ArrayList<>();
    ArmDynamics dynamics = new ArmDynamics(arm);
    double rotor = arm.actuators().get(0).rotorInertiaKgM2();
    for (ArmSample each : swinging(arm, Payload.NONE)) {
      Joints qdd = new Joints(each.accelerationRadPerS2().q0(), 0, 0, 0, 0, 0);
      double[] torque = new double[Joints.COUNT];
      dynamics.inverse(each.positionRad().toArray(), Joints.ZERO.toArray(), qdd.toArray(), torque);
      torque[0] += 2 * rotor * qdd.q0();
      still.add(new ArmSample(each.positionRad(), Joints.ZERO, qdd, Joints.of(torque)));
    }

    LoadFit.Found found =
        found(LoadFit.of(arm, Gravity.UPRIGHT, still, Optional.of(Payload.NONE), Payload.NONE));

    assertEquals(2 * rotor, found.rotorInertiaKgM2().get(0).orElseThrow(), 1e-6);
    assertEquals(OptionalDouble.empty(), found.rotorInertiaKgM2().get(1));
  }

  @Test
  void momentsThatLackWeightAreRefused() {
    ArmDescription arm = ArmLibrary.load("ur5e");
    List<ArmSample> light = new ArrayList<>();
    for (ArmSample each : swinging(ArmLibrary.load("ur3e"), Payload.NONE)) {
      light.add(each);
    }

    LoadFit.Refused refused =
        assertInstanceOf(
            LoadFit.Refused.class,
            LoadFit.of(arm, Gravity.UPRIGHT, light, Optional.empty(), Payload.NONE));

    assertTrue(refused.reason().contains("is the robot another one?"), refused.reason());
  }
}
