package org.pendant.motion.offset;

import org.pendant.models.pose.Transforms;

/**
 * Motion frame: follows a path with x along its tangent, y across it and the tool's z axis, z
 * completes them (manual 15.37). Where the tool rests, or moves along its own z axis, it stays as
 * it was.
 */
final class MotionFrame {
  /** A way in a frame below this, m, has no direction: 0.5 micrometres per second. */
  private static final double RESTS_M = 1e-9;

  /** Sine of the angle below which tangent and tool are parallel. */
  private static final double PARALLEL = 1e-3;

  private final double[] rotation = new double[9];
  private final double[] place = new double[3];
  private boolean placed;
  private boolean known;

  /** Nothing is known of a path. */
  void forget() {
    placed = false;
    known = false;
  }

  /** Whether there has been a direction. */
  boolean known() {
    return known;
  }

  /** Its axes in the base, as columns of a rotation matrix. */
  double[] rotation() {
    return rotation;
  }

  /** A frame later, with the TCP there. */
  void follow(double[] tcpInBase) {
    double x = tcpInBase[9] - place[0];
    double y = tcpInBase[10] - place[1];
    double z = tcpInBase[11] - place[2];
    System.arraycopy(tcpInBase, Transforms.SIZE - 3, place, 0, 3);
    if (placed) {
      turnTo(x, y, z, tcpInBase);
    }
    placed = true;
  }

  private void turnTo(double x, double y, double z, double[] tcp) {
    double moved = Math.sqrt(x * x + y * y + z * z);
    if (moved < RESTS_M) {
      return;
    }
    double tx = x / moved;
    double ty = y / moved;
    double tz = z / moved;
    double sx = ty * tcp[8] - tz * tcp[5];
    double sy = tz * tcp[2] - tx * tcp[8];
    double sz = tx * tcp[5] - ty * tcp[2];
    double sine = Math.sqrt(sx * sx + sy * sy + sz * sz);
    if (sine < PARALLEL) {
      return;
    }
    known = true;
    column(0, tx, ty, tz);
    column(1, sx / sine, sy / sine, sz / sine);
    column(2, (ty * sz - tz * sy) / sine, (tz * sx - tx * sz) / sine, (tx * sy - ty * sx) / sine);
  }

  private void column(int column, double x, double y, double z) {
    rotation[column] = x;
    rotation[3 + column] = y;
    rotation[6 + column] = z;
  }
}
