package org.pendant.models.arm;

/**
 * Denavit-Hartenberg deltas: what one arm's calibration adds to the Denavit-Hartenberg parameters
 * of its model, joint by joint: {@code T_i = Rz(q_i + thetaRad_i) Tz(d_i + dM_i) Tx(a_i + aM_i)
 * Rx(alpha_i + alphaRad_i)}, in the convention of {@link DhLengths}.
 *
 * <p>The angles are small, and so are most lengths. Along the parallel axes 2 and 3 a calibration
 * may shift the links by metres one way and back again: what tells these shifts apart is the tiny
 * angle between the axes alone.
 *
 * @param thetaRad added to the joint positions, rad
 * @param aM added to the lengths along the x axes, m
 * @param dM added to the lengths along the joints' axes, m
 * @param alphaRad added to the angles between the joints' axes, rad
 */
public record DhDeltas(Joints thetaRad, Joints aM, Joints dM, Joints alphaRad) {
  /** An arm exactly as its model says. */
  public static final DhDeltas NONE =
      new DhDeltas(Joints.ZERO, Joints.ZERO, Joints.ZERO, Joints.ZERO);

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is not finite
   */
  public DhDeltas {
    requireFinite("theta", thetaRad, "rad");
    requireFinite("a", aM, "m");
    requireFinite("d", dM, "m");
    requireFinite("alpha", alphaRad, "rad");
  }

  private static void requireFinite(String name, Joints deltas, String unit) {
    for (int i = 0; i < Joints.COUNT; i++) {
      if (!Double.isFinite(deltas.get(i))) {
        throw new IllegalArgumentException(
            "dh deltas: "
                + name
                + " of joint "
                + i
                + " is "
                + deltas.get(i)
                + " "
                + unit
                + ", must be finite");
      }
    }
  }
}
