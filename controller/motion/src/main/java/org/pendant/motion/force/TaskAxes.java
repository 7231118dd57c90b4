package org.pendant.motion.force;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Task axes: the axes of force mode's task frame in the base frame, as they are in a frame of the
 * loop.
 */
final class TaskAxes {
  /** The nearest that the origin may be to point the y axis at, m (manual 15.12, type 1). */
  static final double NEAREST_POINT_M = 0.01;

  /** Slower than this the path does not say where to point the x axis, m/s. */
  private static final double MIN_M_PER_S = 1e-3;

  /** Below this sine two directions are taken to be parallel. */
  private static final double PARALLEL = 1e-6;

  private final double[] given = new double[Transforms.SIZE];

  /** Rotation matrix in rows; its columns are the axes along those of the base. */
  private final double[] axes = new double[9];

  private FrameKind kind = FrameKind.FIXED;
  private boolean known;

  /** The task frame of {@code task} counts from now on. */
  void begin(ForceTask task) {
    Pose frame = task.taskFrame();
    Transforms.of(frame, given);
    Rotations.vectorToMatrix(frame.rx(), frame.ry(), frame.rz(), axes);
    kind = task.kind();
    known = kind != FrameKind.MOTION;
  }

  /**
   * Turns the axes to where they are now.
   *
   * @param tcp12 where the TCP is to be, in the base frame
   * @param pathTwist6 how the path moves it, m/s and rad/s along the axes of the base
   */
  void update(double[] tcp12, double[] pathTwist6) {
    switch (kind) {
      case FIXED -> {}
      case TOOL -> System.arraycopy(tcp12, 0, axes, 0, axes.length);
      case POINT -> point(given[9] - tcp12[9], given[10] - tcp12[10], given[11] - tcp12[11]);
      case MOTION -> follow(pathTwist6[0], pathTwist6[1], pathTwist6[2]);
    }
  }

  /** Points y along a direction; nearer than 10 mm the axes stay as they are. */
  private void point(double dx, double dy, double dz) {
    double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
    if (length < NEAREST_POINT_M) {
      return;
    }
    double yx = dx / length;
    double yy = dy / length;
    double yz = dz / length;
    if (!pointX(
        yx,
        yy,
        yz,
        yy * given[8] - yz * given[5],
        yz * given[2] - yx * given[8],
        yx * given[5] - yy * given[2])) {
      // y is along the given z: what is left of the given x serves as well
      double along = yx * given[0] + yy * given[3] + yz * given[6];
      pointX(yx, yy, yz, given[0] - along * yx, given[3] - along * yy, given[6] - along * yz);
    }
  }

  /** Takes x, at a right angle to y, if it is long enough to have a direction. */
  private boolean pointX(double yx, double yy, double yz, double x, double y, double z) {
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length < PARALLEL) {
      return false;
    }
    set(x / length, y / length, z / length, yx, yy, yz);
    return true;
  }

  /** Points x along a velocity, as far as it is along the given x and y. */
  private void follow(double vx, double vy, double vz) {
    double x = vx * given[0] + vy * given[3] + vz * given[6];
    double y = vx * given[1] + vy * given[4] + vz * given[7];
    double speed = Math.sqrt(x * x + y * y);
    if (speed < MIN_M_PER_S) {
      return;
    }
    double c = x / speed;
    double s = y / speed;
    set(
        c * given[0] + s * given[1],
        c * given[3] + s * given[4],
        c * given[6] + s * given[7],
        c * given[1] - s * given[0],
        c * given[4] - s * given[3],
        c * given[7] - s * given[6]);
    known = true;
  }

  /** Sets x and y, and z at right angles to both. */
  private void set(double xx, double xy, double xz, double yx, double yy, double yz) {
    axes[0] = xx;
    axes[3] = xy;
    axes[6] = xz;
    axes[1] = yx;
    axes[4] = yy;
    axes[7] = yz;
    axes[2] = xy * yz - xz * yy;
    axes[5] = xz * yx - xx * yz;
    axes[8] = xx * yy - xy * yx;
  }

  /** Whether there are axes already: with type 3 the path has to move first. */
  boolean known() {
    return known;
  }

  /**
   * What twelve, six or three numbers have along axis {@code axis} (0 to 2), from {@code at} on.
   */
  double along(int axis, double[] vector, int at) {
    return axes[axis] * vector[at]
        + axes[3 + axis] * vector[at + 1]
        + axes[6 + axis] * vector[at + 2];
  }

  /** Adds {@code amount} along axis {@code axis} (0 to 2) to three numbers from {@code at} on. */
  void add(int axis, double amount, double[] vector, int at) {
    for (int row = 0; row < 3; row++) {
      vector[at + row] += amount * axes[3 * row + axis];
    }
  }
}
