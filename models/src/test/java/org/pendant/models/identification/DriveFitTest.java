package org.pendant.models.identification;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Actuator;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Confidence;
import org.pendant.models.arm.FrictionCurve;

class DriveFitTest {
  private static final int SAMPLES = 400;

  private final Actuator model = ArmLibrary.load("ur5e").actuators().get(1);

  /** A drive whose torque constant and friction are others than described. */
  private static Actuator drive(double constant, FrictionCurve friction) {
    return new Actuator(
        1.5,
        constant,
        friction,
        Actuator.USUAL_LAG_S,
        new Actuator.Status(Confidence.ASSUMED, Confidence.ASSUMED, Confidence.ASSUMED));
  }

  /** Speeds to and fro up to {@code top} rad/s. */
  private static double[] speeds(double top) {
    double[] v = new double[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
      v[i] = top * Math.sin(0.05 * i);
    }
    return v;
  }

  /** Moments that change with the posture, Nm. */
  private static double[] moments(double mean, double amplitude) {
    double[] moments = new double[SAMPLES];
    for (int i = 0; i < SAMPLES; i++) {
      moments[i] = mean + amplitude * Math.cos(0.013 * i);
    }
    return moments;
  }

  private static double[] currents(Actuator drive, double[] v, double[] moments, double noiseA) {
    SplittableRandom random = new SplittableRandom(1);
    double[] currents = new double[v.length];
    for (int i = 0; i < v.length; i++) {
      currents[i] =
          moments[i] / drive.torqueConstantNmPerA()
              + drive.friction().currentA(v[i], moments[i])
              + noiseA * random.nextGaussian();
    }
    return currents;
  }

  @Test
  void findsTorqueConstantAndFrictionOfAMovingJoint() {
    Actuator true0 = drive(12.5, new FrictionCurve(0.8, 0.4, 0.5, 0.7, 0));
    double[] v = speeds(1.5);
    double[] moments = moments(30, 25);

    DriveFit fit = DriveFit.of(model, v, moments, currents(true0, v, moments, 0)).orElseThrow();

    assertTrue(fit.torqueConstantFound());
    assertEquals(12.5, fit.actuator().torqueConstantNmPerA(), 0.01);
    assertEquals(0, fit.rmsAfterA(), 0.002);
    assertTrue(fit.rmsBeforeA() > 0.1, "the description was another one");
    for (double speed : new double[] {0.05, 0.1, 0.5, 1, 1.5}) {
      assertEquals(
          true0.friction().currentA(speed, 0),
          fit.actuator().friction().currentA(speed, 0),
          0.005,
          "at " + speed + " rad/s");
    }
    assertEquals(Confidence.MEASURED, fit.actuator().status().friction());
    assertEquals(model.status().rotorInertia(), fit.actuator().status().rotorInertia());
  }

  @Test
  void noiseMovesTheCurveByLittle() {
    Actuator true0 = drive(11, new FrictionCurve(0.6, 0.3, 0.4, 0.5, 0));
    double[] v = speeds(1);
    double[] moments = moments(10, 8);

    DriveFit fit = DriveFit.of(model, v, moments, currents(true0, v, moments, 0.05)).orElseThrow();

    assertEquals(0.05, fit.rmsAfterA(), 0.005);
    for (double speed : new double[] {0.1, 0.5, 1}) {
      assertEquals(
          true0.friction().currentA(speed, 0),
          fit.actuator().friction().currentA(speed, 0),
          0.03,
          "at " + speed + " rad/s");
    }
  }

  @Test
  void aMomentThatIsNotThereLeavesTheTorqueConstant() {
    Actuator true0 = drive(20, new FrictionCurve(0.6, 0.3, 0.4, 0.5, 0));
    double[] v = speeds(1);
    double[] none = new double[SAMPLES];

    DriveFit fit = DriveFit.of(model, v, none, currents(true0, v, none, 0)).orElseThrow();

    assertFalse(fit.torqueConstantFound());
    assertEquals(model.torqueConstantNmPerA(), fit.actuator().torqueConstantNmPerA());
    assertEquals(model.status().torqueConstant(), fit.actuator().status().torqueConstant());
    assertEquals(0, fit.rmsAfterA(), 0.002);
  }

  @Test
  void frictionWithoutViscosityGetsNoNegativeOne() {
    Actuator true0 = drive(10.88, new FrictionCurve(0.6, 0, 1, 0, 0));
    double[] v = speeds(1);
    double[] moments = moments(10, 8);

    DriveFit fit = DriveFit.of(model, v, moments, currents(true0, v, moments, 0.02)).orElseThrow();

    assertTrue(fit.actuator().friction().viscousASPerRad() >= 0);
    assertEquals(0.6, fit.actuator().friction().currentA(0.5, 0), 0.01);
  }

  @Test
  void aJointThatHardlyTurnsTellsNothing() {
    double[] v = speeds(0.9 * DriveFit.MIN_SPEED_RAD_PER_S);
    double[] moments = moments(10, 8);

    assertEquals(Optional.empty(), DriveFit.of(model, v, moments, currents(model, v, moments, 0)));
  }
}
