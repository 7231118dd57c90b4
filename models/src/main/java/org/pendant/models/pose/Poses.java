package org.pendant.models.pose;

/**
 * The algebra of poses behind URScript's {@code pose_...} functions (manual 17.13, 17.14, 17.19 to
 * 17.24).
 *
 * <p>Rotations are composed as unit quaternions and given back as the shortest rotation vector (see
 * {@link Rotations} for the choice at half a turn). {@link #trans} and {@link #inverse} allocate
 * nothing but their result. Components that are not finite give components that are not finite.
 */
public final class Poses {
  /** Metres that one radian counts in {@link #distance} (manual 17.21). */
  private static final double METRES_PER_RADIAN = 0.25;

  private Poses() {}

  /**
   * The pose reached by starting at {@code a} and moving by {@code b} as seen from there: the
   * product of the two transformations (pose_trans, manual 17.24).
   */
  public static Pose trans(Pose a, Pose b) {
    double angleA = angle(a);
    double sa = Rotations.halfSine(angleA);
    double aw = Math.cos(0.5 * angleA);
    double ax = sa * a.rx();
    double ay = sa * a.ry();
    double az = sa * a.rz();
    double angleB = angle(b);
    double sb = Rotations.halfSine(angleB);
    double bw = Math.cos(0.5 * angleB);
    double bx = sb * b.rx();
    double by = sb * b.ry();
    double bz = sb * b.rz();
    // position of b turned by a: p + 2 w (v x p) + 2 v x (v x p)
    double tx = 2 * (ay * b.z() - az * b.y());
    double ty = 2 * (az * b.x() - ax * b.z());
    double tz = 2 * (ax * b.y() - ay * b.x());
    return pose(
        a.x() + b.x() + aw * tx + ay * tz - az * ty,
        a.y() + b.y() + aw * ty + az * tx - ax * tz,
        a.z() + b.z() + aw * tz + ax * ty - ay * tx,
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw);
  }

  /** The pose of the reference frame seen from {@code p} (pose_inv, manual 17.22). */
  public static Pose inverse(Pose p) {
    double angle = angle(p);
    double s = Rotations.halfSine(angle);
    double w = Math.cos(0.5 * angle);
    double x = -s * p.rx();
    double y = -s * p.ry();
    double z = -s * p.rz();
    double tx = 2 * (y * p.z() - z * p.y());
    double ty = 2 * (z * p.x() - x * p.z());
    double tz = 2 * (x * p.y() - y * p.x());
    return pose(
        -(p.x() + w * tx + y * tz - z * ty),
        -(p.y() + w * ty + z * tx - x * tz),
        -(p.z() + w * tz + x * ty - y * tx),
        w,
        x,
        y,
        z);
  }

  /**
   * Sum of the positions and product of the rotations, {@code a}'s on the left (pose_add, manual
   * 17.20).
   */
  public static Pose add(Pose a, Pose b) {
    Pose turned = trans(new Pose(0, 0, 0, a.rx(), a.ry(), a.rz()), rotationOf(b));
    return new Pose(
        a.x() + b.x(), a.y() + b.y(), a.z() + b.z(), turned.rx(), turned.ry(), turned.rz());
  }

  /**
   * Difference of the positions, and the rotation {@code R_to R_from^-1} that leads, turning about
   * axes of the reference frame, from one orientation to the other (pose_sub, manual 17.23).
   */
  public static Pose sub(Pose to, Pose from) {
    Pose turned = trans(rotationOf(to), new Pose(0, 0, 0, -from.rx(), -from.ry(), -from.rz()));
    return new Pose(
        to.x() - from.x(),
        to.y() - from.y(),
        to.z() - from.z(),
        turned.rx(),
        turned.ry(),
        turned.rz());
  }

  /**
   * The pose at the fraction {@code alpha} of the straight way from one pose to another, the
   * orientation turning evenly about one axis the shorter way round (interpolate_pose, manual
   * 17.13). Fractions outside 0 to 1 extend the line; 0 and 1 give the ends themselves.
   */
  public static Pose interpolate(Pose from, Pose to, double alpha) {
    return new StraightLine(from, to).at(alpha);
  }

  /** Distance of the positions in m (point_dist, manual 17.19). */
  public static double pointDistance(Pose a, Pose b) {
    double dx = b.x() - a.x();
    double dy = b.y() - a.y();
    double dz = b.z() - a.z();
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  /** Angle in rad, 0 to pi, of the rotation from one orientation to the other. */
  public static double rotationAngle(Pose a, Pose b) {
    return angle(sub(b, a));
  }

  /**
   * The larger of the distance in m and a quarter of the angle in rad (pose_dist, manual 17.21).
   */
  public static double distance(Pose a, Pose b) {
    return Math.max(pointDistance(a, b), METRES_PER_RADIAN * rotationAngle(a, b));
  }

  /** The pose at a position with the rotation of a unit quaternion. */
  static Pose pose(double px, double py, double pz, double w, double x, double y, double z) {
    double f = Rotations.vectorFactor(w, x, y, z);
    return new Pose(px, py, pz, f * x, f * y, f * z);
  }

  private static Pose rotationOf(Pose p) {
    return new Pose(0, 0, 0, p.rx(), p.ry(), p.rz());
  }

  private static double angle(Pose p) {
    return Math.sqrt(p.rx() * p.rx() + p.ry() * p.ry() + p.rz() * p.rz());
  }
}
