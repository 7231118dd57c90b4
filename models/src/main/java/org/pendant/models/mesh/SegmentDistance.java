package org.pendant.models.mesh;

/** Distances of straight lines from one point to another. */
public final class SegmentDistance {
  /** Lines shorter than this are points, squared, m². */
  private static final double POINT_M2 = 1e-18;

  private SegmentDistance() {}

  /** Distance of a point from the line from a to b, m. */
  public static double toPoint(
      double ax,
      double ay,
      double az,
      double bx,
      double by,
      double bz,
      double px,
      double py,
      double pz) {
    double x = bx - ax;
    double y = by - ay;
    double z = bz - az;
    double square = x * x + y * y + z * z;
    double share =
        square < POINT_M2 ? 0 : clamp(((px - ax) * x + (py - ay) * y + (pz - az) * z) / square);
    double dx = ax + share * x - px;
    double dy = ay + share * y - py;
    double dz = az + share * z - pz;
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  /**
   * Distance of two lines, m. (C. Ericson: "Real-Time Collision Detection", 5.1.9.)
   *
   * @param ends1 x, y and z of both ends of the first, from {@code at1} on
   * @param ends2 the same of the second, from {@code at2} on
   */
  public static double apart(double[] ends1, int at1, double[] ends2, int at2) {
    double x1 = ends1[at1 + 3] - ends1[at1];
    double y1 = ends1[at1 + 4] - ends1[at1 + 1];
    double z1 = ends1[at1 + 5] - ends1[at1 + 2];
    double x2 = ends2[at2 + 3] - ends2[at2];
    double y2 = ends2[at2 + 4] - ends2[at2 + 1];
    double z2 = ends2[at2 + 5] - ends2[at2 + 2];
    double rx = ends1[at1] - ends2[at2];
    double ry = ends1[at1 + 1] - ends2[at2 + 1];
    double rz = ends1[at1 + 2] - ends2[at2 + 2];
    double square1 = x1 * x1 + y1 * y1 + z1 * z1;
    double square2 = x2 * x2 + y2 * y2 + z2 * z2;
    double along2 = x2 * rx + y2 * ry + z2 * rz;
    double s;
    double t;
    if (square1 < POINT_M2) {
      s = 0;
      t = square2 < POINT_M2 ? 0 : clamp(along2 / square2);
    } else {
      double along1 = x1 * rx + y1 * ry + z1 * rz;
      if (square2 < POINT_M2) {
        t = 0;
        s = clamp(-along1 / square1);
      } else {
        double dot = x1 * x2 + y1 * y2 + z1 * z2;
        double square = square1 * square2 - dot * dot;
        // of parallel lines any point will do to begin with
        s = square > 0 ? clamp((dot * along2 - along1 * square2) / square) : 0;
        t = (dot * s + along2) / square2;
        if (t < 0) {
          t = 0;
          s = clamp(-along1 / square1);
        } else if (t > 1) {
          t = 1;
          s = clamp((dot - along1) / square1);
        }
      }
    }
    double dx = rx + s * x1 - t * x2;
    double dy = ry + s * y1 - t * y2;
    double dz = rz + s * z1 - t * z2;
    return Math.sqrt(dx * dx + dy * dy + dz * dz);
  }

  private static double clamp(double share) {
    return Math.min(1, Math.max(0, share));
  }
}
