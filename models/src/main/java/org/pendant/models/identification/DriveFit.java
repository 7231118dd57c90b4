package org.pendant.models.identification;

import java.util.Optional;
import org.pendant.models.arm.Actuator;

/**
 * Drive fit: torque constant and friction curve of one joint from its currents.
 *
 * <p>{@code current = moment / K + Fc tanh(v / 0.0079) + F1 tanh(v / v1) + B v} is linear in all
 * but v1, which is searched for; no number may be negative. What of the dry friction comes with the
 * load is taken over from the description.
 *
 * @param actuator the drive with the numbers found
 * @param torqueConstantFound whether the torque constant is among them: the moment has to vary
 * @param rmsBeforeA what the description leaves unexplained, A
 * @param rmsAfterA what the numbers found leave, A
 */
public record DriveFit(
    Actuator actuator, boolean torqueConstantFound, double rmsBeforeA, double rmsAfterA) {
  /** A joint that never turns faster does not tell its friction, rad/s. */
  public static final double MIN_SPEED_RAD_PER_S = 0.05;

  /** Fewest samples in motion. */
  public static final int MIN_SAMPLES = 20;

  /**
   * Finds the numbers of a drive; empty when the joint hardly turns.
   *
   * @param model the drive as described
   * @param speedRadPerS of the samples, rad/s
   * @param momentNm what links, payload and rotor need, Nm
   * @param currentA of the drive, A
   */
  public static Optional<DriveFit> of(
      Actuator model, double[] speedRadPerS, double[] momentNm, double[] currentA) {
    int moving = 0;
    for (double each : speedRadPerS) {
      moving += Math.abs(each) >= MIN_SPEED_RAD_PER_S ? 1 : 0;
    }
    if (moving < MIN_SAMPLES) {
      return Optional.empty();
    }
    return Optional.of(new DriveEquations(model, speedRadPerS, momentNm, currentA).solve());
  }
}
