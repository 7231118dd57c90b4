package org.pendant.models.pose;

/**
 * The straight way from one pose to another: the position on a line, the orientation turning evenly
 * about one fixed axis the shorter way round.
 *
 * <p>What depends on the ends alone is computed once, so asking for many points (a linear move asks
 * once a frame) costs two trigonometric calls each. When the ends differ by half a turn exactly,
 * both ways round are equally short and the axis of {@link Rotations} is taken.
 */
public final class StraightLine {
  private final Pose from;
  private final Pose to;
  private final double qw;
  private final double qx;
  private final double qy;
  private final double qz;
  private final double turnX;
  private final double turnY;
  private final double turnZ;
  private final double turn;
  private final double length;

  /** The line between two poses in the same frame. */
  public StraightLine(Pose from, Pose to) {
    this.from = from;
    this.to = to;
    double[] q = new double[4];
    Rotations.vectorToQuaternion(from.rx(), from.ry(), from.rz(), q);
    qw = q[0];
    qx = q[1];
    qy = q[2];
    qz = q[3];
    Pose difference = Poses.sub(to, from);
    turnX = difference.rx();
    turnY = difference.ry();
    turnZ = difference.rz();
    turn = Math.sqrt(turnX * turnX + turnY * turnY + turnZ * turnZ);
    length = Poses.pointDistance(from, to);
  }

  /** The pose at fraction 0. */
  public Pose from() {
    return from;
  }

  /** The pose at fraction 1. */
  public Pose to() {
    return to;
  }

  /** Distance of the end positions in m. */
  public double lengthM() {
    return length;
  }

  /** Angle between the end orientations in rad, 0 to pi. */
  public double angleRad() {
    return turn;
  }

  /**
   * Change per unit of fraction: difference of the positions in m and rotation vector in rad, both
   * in the frame of the ends. Times the fraction's rate it is the twist of the motion.
   */
  public Pose rate() {
    return new Pose(to.x() - from.x(), to.y() - from.y(), to.z() - from.z(), turnX, turnY, turnZ);
  }

  /** The pose at a fraction of the way; outside 0 to 1 the line continues. */
  public Pose at(double fraction) {
    if (fraction == 0) {
      return from;
    }
    if (fraction == 1) {
      return to;
    }
    double s = fraction * Rotations.halfSine(Math.abs(fraction) * turn);
    double w = Math.cos(0.5 * fraction * turn);
    double x = s * turnX;
    double y = s * turnY;
    double z = s * turnZ;
    return Poses.pose(
        from.x() + fraction * (to.x() - from.x()),
        from.y() + fraction * (to.y() - from.y()),
        from.z() + fraction * (to.z() - from.z()),
        w * qw - x * qx - y * qy - z * qz,
        w * qx + x * qw + y * qz - z * qy,
        w * qy - x * qz + y * qw + z * qx,
        w * qz + x * qy - y * qx + z * qw);
  }

  /**
   * The transformation (see {@link Transforms}) at a fraction of the way, without allocating.
   *
   * @param transform twelve numbers, overwritten
   */
  public void at(double fraction, double[] transform) {
    double s = fraction * Rotations.halfSine(Math.abs(fraction) * turn);
    double w = Math.cos(0.5 * fraction * turn);
    double x = s * turnX;
    double y = s * turnY;
    double z = s * turnZ;
    Rotations.quaternionToMatrix(
        w * qw - x * qx - y * qy - z * qz,
        w * qx + x * qw + y * qz - z * qy,
        w * qy - x * qz + y * qw + z * qx,
        w * qz + x * qy - y * qx + z * qw,
        transform);
    transform[9] = from.x() + fraction * (to.x() - from.x());
    transform[10] = from.y() + fraction * (to.y() - from.y());
    transform[11] = from.z() + fraction * (to.z() - from.z());
  }
}
