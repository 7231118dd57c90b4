package org.pendant.controller.freedrive;

import java.util.OptionalDouble;
import org.pendant.controller.arm.SimulatedArm;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.ArmDynamics;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.pose.Wrench;

/**
 * Payload check: whether the declared payload is what the flange carries, by its force/torque
 * sensor. The sensor cannot tell a load from a hand that pushes the tool.
 */
final class PayloadCheck {
  /** Share of the rated payload that the declared one may be wrong by; our choice. */
  private static final double SHARE = 0.15;

  /** Small arms may be wrong by this, N. */
  private static final double MIN_N = 5;

  /** How far off the centre of the allowed wrong weight may be, m. */
  private static final double LEVER_M = 0.1;

  private final double toleranceN;

  PayloadCheck(ArmDescription arm) {
    toleranceN = Math.max(MIN_N, SHARE * arm.payloadKg() * ArmDynamics.STANDARD_GRAVITY_M_PER_S2);
  }

  /** What may be felt beyond the declared payload, N. */
  double toleranceN() {
    return toleranceN;
  }

  /**
   * By how much a payload is wrong, as a force in N: a torque counts as that force at the end of a
   * lever. Empty if it is right.
   */
  OptionalDouble errorN(SimulatedArm arm, Payload declared) {
    Wrench felt = arm.loadOnFlange();
    Wrench expected = arm.weightOf(declared);
    double force =
        length(felt.fx() - expected.fx(), felt.fy() - expected.fy(), felt.fz() - expected.fz());
    double torque =
        length(felt.mx() - expected.mx(), felt.my() - expected.my(), felt.mz() - expected.mz());
    double error = Math.max(force, torque / LEVER_M);
    return error > toleranceN ? OptionalDouble.of(error) : OptionalDouble.empty();
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }
}
