package org.pendant.motion.force;

import java.util.Arrays;
import org.pendant.models.pose.Rotations;
import org.pendant.models.time.FrameTime;

/**
 * Compliance offset: displacement and rotation of the TCP from its path by force mode, in the base
 * frame.
 */
final class ComplianceOffset {
  private static final double[] STRAIGHT = {1, 0, 0, 0, 1, 0, 0, 0, 1};

  private final double[] way = new double[3];
  private final double[] wayBefore = new double[3];

  /** Unit quaternion w, x, y, z. */
  private final double[] turn = new double[4];

  private final double[] turn9 = new double[9];
  private final double[] turnBefore9 = new double[9];
  private final double[] vector = new double[3];
  private final double[] was = new double[9];

  ComplianceOffset() {
    clear();
  }

  /** Nothing is carried. */
  void clear() {
    Arrays.fill(way, 0);
    Arrays.fill(turn, 0);
    turn[0] = 1;
    System.arraycopy(STRAIGHT, 0, turn9, 0, 9);
    remember();
  }

  private void remember() {
    System.arraycopy(way, 0, wayBefore, 0, 3);
    System.arraycopy(turn9, 0, turnBefore9, 0, 9);
  }

  /** Continues for a frame at a velocity in m/s and rad/s, along the axes of the base. */
  void advance(double[] twist6) {
    remember();
    for (int i = 0; i < 3; i++) {
      way[i] += FrameTime.FRAME_S * twist6[i];
    }
    // half of an angle this small is its sine
    double rx = 0.5 * FrameTime.FRAME_S * twist6[3];
    double ry = 0.5 * FrameTime.FRAME_S * twist6[4];
    double rz = 0.5 * FrameTime.FRAME_S * twist6[5];
    if (rx != 0 || ry != 0 || rz != 0) {
      turnBy(rx, ry, rz);
    }
  }

  private void turnBy(double rx, double ry, double rz) {
    double w = turn[0] - rx * turn[1] - ry * turn[2] - rz * turn[3];
    double x = turn[1] + rx * turn[0] + ry * turn[3] - rz * turn[2];
    double y = turn[2] + ry * turn[0] + rz * turn[1] - rx * turn[3];
    double z = turn[3] + rz * turn[0] + rx * turn[2] - ry * turn[1];
    double length = Math.sqrt(w * w + x * x + y * y + z * z);
    turn[0] = w / length;
    turn[1] = x / length;
    turn[2] = y / length;
    turn[3] = z / length;
    Rotations.quaternionToMatrix(turn[0], turn[1], turn[2], turn[3], turn9);
  }

  /** Carries a TCP, given as it is on its path in the base frame. */
  void apply(double[] tcp12) {
    for (int row = 0; row < 3; row++) {
      tcp12[9 + row] += way[row];
    }
    System.arraycopy(tcp12, 0, was, 0, 9);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        tcp12[3 * row + column] =
            turn9[3 * row] * was[column]
                + turn9[3 * row + 1] * was[3 + column]
                + turn9[3 * row + 2] * was[6 + column];
      }
    }
  }

  /**
   * Brings a TCP back to its path.
   *
   * @param framesAgo 0 as it is carried now, 1 as it was before the last {@link #advance}
   */
  void undo(double[] tcp12, int framesAgo) {
    double[] from = framesAgo == 0 ? way : wayBefore;
    double[] turned = framesAgo == 0 ? turn9 : turnBefore9;
    for (int row = 0; row < 3; row++) {
      tcp12[9 + row] -= from[row];
    }
    System.arraycopy(tcp12, 0, was, 0, 9);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        tcp12[3 * row + column] =
            turned[row] * was[column]
                + turned[3 + row] * was[3 + column]
                + turned[6 + row] * was[6 + column];
      }
    }
  }

  /**
   * Another point of the tool is carried from now on, without moving the tool. The parameters are
   * the way from the point before to this one on the path, along the axes of the base, m.
   */
  void movePoint(double x, double y, double z) {
    for (int row = 0; row < 3; row++) {
      way[row] += turn9[3 * row] * x + turn9[3 * row + 1] * y + turn9[3 * row + 2] * z;
    }
    way[0] -= x;
    way[1] -= y;
    way[2] -= z;
    remember();
  }

  /** How far it is carried along or about each axis of a task frame, m and rad. */
  void measure(TaskAxes axes, double[] deviation6) {
    Rotations.quaternionToVector(turn[0], turn[1], turn[2], turn[3], vector);
    for (int i = 0; i < 3; i++) {
      deviation6[i] = axes.along(i, way, 0);
      deviation6[3 + i] = axes.along(i, vector, 0);
    }
  }
}
