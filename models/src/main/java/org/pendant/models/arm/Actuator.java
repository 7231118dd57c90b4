package org.pendant.models.arm;

import org.pendant.models.time.FrameTime;

/**
 * The drive of one joint: motor, gear and bearings, seen from the joint.
 *
 * @param rotorInertiaKgM2 inertia of the motor behind the gear, kg m²
 * @param torqueConstantNmPerA torque that one ampere gives, Nm/A
 * @param friction what friction takes of the current
 * @param lagS how far it lags behind its target, s
 * @param status how far the numbers can be trusted
 */
public record Actuator(
    double rotorInertiaKgM2,
    double torqueConstantNmPerA,
    FrictionCurve friction,
    double lagS,
    Status status) {
  /** Lag of the drives of an e-Series arm as recorded, s. */
  public static final double USUAL_LAG_S = 0.00049;

  /** The longest lag, s: what a drive follows lies between this frame's target and the last. */
  public static final double MAX_LAG_S = FrameTime.FRAME_S;

  /**
   * Trust in each number of a drive.
   *
   * @param rotorInertia of the rotor's inertia
   * @param torqueConstant of the torque constant
   * @param friction of the friction curve
   */
  public record Status(Confidence rotorInertia, Confidence torqueConstant, Confidence friction) {}

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the inertia is negative, the torque constant not above 0 or
   *     the lag not from 0 to {@link #MAX_LAG_S}
   */
  public Actuator {
    if (!(rotorInertiaKgM2 >= 0) || rotorInertiaKgM2 == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "actuator: rotorInertiaKgM2 is "
              + rotorInertiaKgM2
              + " kg m\u00b2, must not be negative");
    }
    if (!(torqueConstantNmPerA > 0) || torqueConstantNmPerA == Double.POSITIVE_INFINITY) {
      throw new IllegalArgumentException(
          "actuator: torqueConstantNmPerA is " + torqueConstantNmPerA + " Nm/A, must be above 0");
    }
    if (!(lagS >= 0 && lagS <= MAX_LAG_S)) {
      throw new IllegalArgumentException(
          "actuator: lagS is " + lagS + " s, must be from 0 to " + MAX_LAG_S);
    }
  }

  /** Dry friction under a load (Nm), Nm. */
  public double dryNm(double loadNm) {
    return torqueConstantNmPerA * friction.dryA(loadNm);
  }

  /** Friction that grows with the speed, over the speed (rad/s), Nm s/rad. */
  public double speedDependentNmSPerRad(double speedRadPerS) {
    return torqueConstantNmPerA * friction.speedDependentASPerRad(speedRadPerS);
  }

  /** All friction of a joint that turns at a positive speed (rad/s) under a load (Nm), Nm. */
  public double slidingNm(double speedRadPerS, double loadNm) {
    return torqueConstantNmPerA * (friction.dryA(loadNm) + friction.speedDependentA(speedRadPerS));
  }

  /** The same drive without friction. */
  public Actuator frictionless() {
    return new Actuator(rotorInertiaKgM2, torqueConstantNmPerA, FrictionCurve.NONE, lagS, status);
  }
}
