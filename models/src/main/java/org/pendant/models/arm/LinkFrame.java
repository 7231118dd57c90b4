package org.pendant.models.arm;

/**
 * Link frame: the place of a joint's frame in that of the joint before it, while the joint is at 0;
 * {@code T(x, y, z) Rz(yaw) Ry(pitch) Rx(roll)}, as URDF has it. The joint turns about z.
 */
public record LinkFrame(
    double xM, double yM, double zM, double rollRad, double pitchRad, double yawRad) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is not finite
   */
  public LinkFrame {
    requireFinite("x", xM, "m");
    requireFinite("y", yM, "m");
    requireFinite("z", zM, "m");
    requireFinite("roll", rollRad, "rad");
    requireFinite("pitch", pitchRad, "rad");
    requireFinite("yaw", yawRad, "rad");
  }

  private static void requireFinite(String name, double value, String unit) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException(
          "link frame: " + name + " is " + value + " " + unit + ", must be finite");
    }
  }
}
