package org.pendant.models.arm;

/**
 * Denavit-Hartenberg deltas: what one arm's calibration adds to the Denavit-Hartenberg parameters
 * of its model, joint by joint: {@code T_i = Rz(q_i + thetaRad_i) Tz(d_i + dM_i) Tx(a_i + aM_i)
 * Rx(alpha_i + alphaRad_i)}, in the convention of {@link DhLengths}.
 *
 * <p>Most are small. The axes of joints 2, 3 and 4 are all but parallel, so that their common
 * normals lie anywhere: calibrations shift links 2 and 3 by kilometres along these axes and back
 * again, with angles theta to match.
 *
 * @param thetaRad added to the joint positions, rad
 * @param aM added to the lengths along the x axes, m
 * @param dM added to the lengths along the joints' axes, m
 * @param alphaRad added to the angles between the joints' axes, rad
 */
public record DhDeltas(Joints thetaRad, Joints aM, Joints dM, Joints alphaRad)
    implements LinkGeometry {
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

  /** What the parameters of an arm add to the lengths of its model. */
  public static DhDeltas between(DhLengths dh, DhParameters ofArm) {
    DhParameters nominal = dh.parameters();
    return new DhDeltas(
        ofArm.thetaRad(),
        sum(ofArm.aM(), -1, nominal.aM()),
        sum(ofArm.dM(), -1, nominal.dM()),
        sum(ofArm.alphaRad(), -1, nominal.alphaRad()));
  }

  /** The parameters of an arm with these deltas and the lengths of its model. */
  public DhParameters on(DhLengths dh) {
    DhParameters nominal = dh.parameters();
    return new DhParameters(
        thetaRad,
        sum(nominal.aM(), 1, aM),
        sum(nominal.dM(), 1, dM),
        sum(nominal.alphaRad(), 1, alphaRad));
  }

  private static Joints sum(Joints a, int sign, Joints b) {
    double[] sum = a.toArray();
    for (int i = 0; i < sum.length; i++) {
      sum[i] += sign * b.get(i);
    }
    return Joints.of(sum);
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
