package org.pendant.models.arm;

/**
 * Denavit-Hartenberg lengths: the six that fix the shape of an arm with this family's joints, in m.
 *
 * <p>Standard (distal) Denavit-Hartenberg convention, {@code T_i = Rz(q_i) Tz(d_i) Tx(a_i)
 * Rx(alpha_i)}, with {@code alpha = (pi/2, 0, 0, pi/2, -pi/2, 0)} and every length not named here
 * zero. Frame 0 is the controller's base frame, frame 6 the flange.
 *
 * @param d1 height of the shoulder over the base, m
 * @param a2 upper arm, m; negative
 * @param a3 forearm, m; negative
 * @param d4 sideways offset of the wrist, m
 * @param d5 wrist 1 to wrist 2, m
 * @param d6 wrist 2 to the flange, m
 */
public record DhLengths(double d1, double a2, double a3, double d4, double d5, double d6) {
  /**
   * Checks the lengths.
   *
   * @throws IllegalArgumentException if one is not finite, or a2 or a3 is zero
   */
  public DhLengths {
    requireFinite("d1", d1);
    requireFinite("a2", a2);
    requireFinite("a3", a3);
    requireFinite("d4", d4);
    requireFinite("d5", d5);
    requireFinite("d6", d6);
    if (a2 == 0 || a3 == 0) {
      throw new IllegalArgumentException(
          "dh: a2 is " + a2 + " m and a3 is " + a3 + " m, neither may be zero");
    }
  }

  /** All parameters of the model, joint by joint. */
  public DhParameters parameters() {
    double quarter = Math.PI / 2;
    return new DhParameters(
        Joints.ZERO,
        new Joints(0, a2, a3, 0, 0, 0),
        new Joints(d1, 0, 0, d4, d5, d6),
        new Joints(quarter, 0, 0, quarter, -quarter, 0));
  }

  private static void requireFinite(String name, double value) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("dh: " + name + " is " + value + " m, must be finite");
    }
  }
}
