package org.pendant.models.collision;

/**
 * Capsule: all that is within a radius of a line from one point to another, in the frame of the
 * body that it belongs to. With one point twice it is a ball.
 *
 * @param body which body of the arm, in the order of {@link LinkCapsules#name}
 * @param ax where the line begins, m, along x
 * @param ay the same along y
 * @param az the same along z
 * @param bx where it ends, m, along x
 * @param by the same along y
 * @param bz the same along z
 * @param radiusM the radius, m, above 0
 */
public record Capsule(
    int body, double ax, double ay, double az, double bx, double by, double bz, double radiusM) {
  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if the radius is not above 0, or there is no such body
   */
  public Capsule {
    if (!(radiusM > 0)) {
      throw new IllegalArgumentException("capsule: radius is " + radiusM + " m, must be above 0");
    }
    if (body < 0 || body >= LinkCapsules.BODIES) {
      throw new IllegalArgumentException(
          "capsule: body is " + body + ", must be 0 to " + (LinkCapsules.BODIES - 1));
    }
  }
}
