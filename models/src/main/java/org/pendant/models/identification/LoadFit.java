package org.pendant.models.identification;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.Gravity;
import org.pendant.models.dynamics.Payload;

/**
 * Load fit: payload and rotor inertias from the moments that a motion needs.
 *
 * <p>With the torque of the links known, {@code moment = links + m a + h b + J qdd}: linear in mass
 * m, first moment h = m c of the payload, and rotor inertia J of each joint. What the payload's own
 * extent adds, h h / m, is taken from the solution before.
 */
public sealed interface LoadFit {
  /** A payload of less than this, kg, counts as none: its centre of gravity would be noise. */
  double MIN_MASS_KG = 0.01;

  /**
   * What the moments tell.
   *
   * @param payload a point mass at its centre of gravity
   * @param rotorInertiaKgM2 six, empty for joints that are hardly accelerated
   * @param rmsBeforeNm what the payload given and the description's rotors leave unexplained, Nm
   * @param rmsAfterNm what the numbers found leave, Nm
   */
  record Found(
      Payload payload, List<OptionalDouble> rotorInertiaKgM2, double rmsBeforeNm, double rmsAfterNm)
      implements LoadFit {
    /** Copies the list. */
    public Found {
      rotorInertiaKgM2 = List.copyOf(rotorInertiaKgM2);
    }
  }

  /**
   * The moments do not tell.
   *
   * @param reason what is wrong with them, as part of a sentence
   */
  record Refused(String reason) implements LoadFit {}

  /**
   * Finds the rotor inertias, and the payload too where it is not given.
   *
   * @param gravity as the arm is mounted
   * @param given the payload, if that is known
   * @param assumed the payload that counts before it is found
   */
  static LoadFit of(
      ArmDescription arm,
      Gravity gravity,
      List<ArmSample> samples,
      Optional<Payload> given,
      Payload assumed) {
    return new LoadEquations(arm, gravity, samples).solve(given, assumed);
  }
}
