package org.pendant.motion;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;

/**
 * Tool blend curve: leads from one straight line of the TCP to the next near the corner between
 * them; its parameter is the time since its start. Position and orientation follow polynomials, the
 * orientation as a rotation vector relative to the orientation in the corner, so that the blend
 * touches both lines' even turning.
 */
final class ToolBlend implements ToolCurve {
  /** Step of the central difference that yields {@link #bend}, s. */
  private static final double STEP_S = 1e-4;

  private static final double SMALL_ANGLE = 1e-4;

  private final Hermite way;
  private final double[] corner = new double[9];
  private final double[] place = new double[Pose.SIZE];
  private final double[] speed = new double[Pose.SIZE];
  private final double[] acceleration = new double[Pose.SIZE];
  private final double[] turn = new double[9];
  private final double[] before = new double[Pose.SIZE];
  private final double[] after = new double[Pose.SIZE];

  /**
   * A blend.
   *
   * @param way position in the base frame, m, and rotation vector from the corner's orientation,
   *     along the axes of the corner, rad
   * @param corner the waypoint that it passes
   */
  ToolBlend(Hermite way, Pose corner) {
    this.way = way;
    Rotations.vectorToMatrix(corner.rx(), corner.ry(), corner.rz(), this.corner);
  }

  @Override
  public void at(double at, double[] transform) {
    way.at(at, place, speed, acceleration);
    Rotations.vectorToMatrix(place[3], place[4], place[5], turn);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        transform[3 * row + column] =
            corner[3 * row] * turn[column]
                + corner[3 * row + 1] * turn[3 + column]
                + corner[3 * row + 2] * turn[6 + column];
      }
    }
    transform[9] = place[0];
    transform[10] = place[1];
    transform[11] = place[2];
  }

  @Override
  public void rate(double at, double[] twist) {
    way.at(at, place, speed, acceleration);
    twist[0] = speed[0];
    twist[1] = speed[1];
    twist[2] = speed[2];
    turning(twist);
  }

  /**
   * The angular velocity about the axes of the base: {@code R1 Jl(w) w'} with the left Jacobian of
   * the rotation group. (T. Barfoot, "State Estimation for Robotics", section 7.1.5.)
   */
  private void turning(double[] twist) {
    double x = place[3];
    double y = place[4];
    double z = place[5];
    double square = x * x + y * y + z * z;
    double angle = Math.sqrt(square);
    double first = angle < SMALL_ANGLE ? 0.5 : (1 - Math.cos(angle)) / square;
    double second = angle < SMALL_ANGLE ? 1 / 6.0 : (angle - Math.sin(angle)) / (square * angle);
    double cx = y * speed[5] - z * speed[4];
    double cy = z * speed[3] - x * speed[5];
    double cz = x * speed[4] - y * speed[3];
    double ox = speed[3] + first * cx + second * (y * cz - z * cy);
    double oy = speed[4] + first * cy + second * (z * cx - x * cz);
    double oz = speed[5] + first * cz + second * (x * cy - y * cx);
    twist[3] = corner[0] * ox + corner[1] * oy + corner[2] * oz;
    twist[4] = corner[3] * ox + corner[4] * oy + corner[5] * oz;
    twist[5] = corner[6] * ox + corner[7] * oy + corner[8] * oz;
  }

  @Override
  public void bend(double at, double[] twist) {
    double low = Math.max(0, at - STEP_S);
    double high = Math.min(way.durationS(), at + STEP_S);
    rate(low, before);
    rate(high, after);
    for (int i = 0; i < Pose.SIZE; i++) {
      twist[i] = (after[i] - before[i]) / (high - low);
    }
  }
}
