package org.pendant.cell;

import org.pendant.models.pose.Rotations;

/**
 * Held place: where a frame holds a body, how far the body is off it, and where it has slipped to.
 */
final class HeldPlace {
  /** Of this step: from the body's origin to what is held, along the base's axes. */
  final double[] arm = new double[3];

  /** Of this step: axes of the frame. */
  final double[][] axes = new double[3][3];

  /** How far the body is off along these, m, then how far it is turned about them, rad. */
  final double[] off = new double[6];

  private final CellBody body;

  /** The place of the body that is held, along its own axes. */
  private final double[] anchor = new double[3];

  /** How the body stands in the frame, rows. */
  private final double[] stand = new double[9];

  private final double[] wished = new double[9];
  private final double[] turn = new double[9];

  HeldPlace(CellBody body, double[] frame) {
    this.body = body;
    double[] pose = body.pose;
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        anchor[i] += pose[3 * k + i] * (frame[9 + k] - pose[9 + k]);
        for (int j = 0; j < 3; j++) {
          stand[3 * i + j] += frame[3 * k + i] * pose[3 * k + j];
        }
      }
    }
  }

  /**
   * Finds how far the body is from where the frame began the step.
   *
   * @param frame where that is at the end of the step, in the base frame
   * @param twist how it moves
   */
  void measure(double[] frame, double[] twist, double stepS) {
    for (int i = 0; i < 3; i++) {
      arm[i] = turned(body.pose, i, anchor);
      for (int k = 0; k < 3; k++) {
        axes[i][k] = frame[3 * k + i];
      }
    }
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        wished[3 * i + j] =
            frame[3 * i] * stand[j]
                + frame[3 * i + 1] * stand[3 + j]
                + frame[3 * i + 2] * stand[6 + j];
      }
    }
    double[] pose = body.pose;
    // half the antisymmetric part of the turn from the wished orientation to the real one
    double x = 0;
    double y = 0;
    double z = 0;
    for (int k = 0; k < 3; k++) {
      x += pose[6 + k] * wished[3 + k] - pose[3 + k] * wished[6 + k];
      y += pose[k] * wished[6 + k] - pose[6 + k] * wished[k];
      z += pose[3 + k] * wished[k] - pose[k] * wished[3 + k];
    }
    double[] turnedOff = {
      x / 2 + twist[3] * stepS, y / 2 + twist[4] * stepS, z / 2 + twist[5] * stepS
    };
    for (int row = 0; row < 3; row++) {
      off[row] = 0;
      off[3 + row] = 0;
      for (int k = 0; k < 3; k++) {
        double shifted = pose[9 + k] + arm[k] - frame[9 + k] + twist[k] * stepS;
        off[row] += axes[row][k] * shifted;
        off[3 + row] += axes[row][k] * turnedOff[k];
      }
    }
  }

  /** What is farther off than these has slipped: across an axis, tilted, and turned about it. */
  void slip(int axis, double shearM, double bendRad, double torsionRad) {
    int a = (axis + 1) % 3;
    int b = (axis + 2) % 3;
    double across = Math.hypot(off[a], off[b]);
    if (across > shearM) {
      slipBy(a, off[a] * (1 - shearM / across));
      slipBy(b, off[b] * (1 - shearM / across));
    }
    double tilt = Math.hypot(off[3 + a], off[3 + b]);
    if (tilt > bendRad) {
      turnBy(a, off[3 + a] * (1 - bendRad / tilt));
      turnBy(b, off[3 + b] * (1 - bendRad / tilt));
    }
    double twisted = off[3 + axis];
    if (Math.abs(twisted) > torsionRad) {
      turnBy(axis, twisted - Math.copySign(torsionRad, twisted));
    }
  }

  private void slipBy(int row, double wayM) {
    off[row] -= wayM;
    for (int i = 0; i < 3; i++) {
      for (int k = 0; k < 3; k++) {
        anchor[i] -= body.pose[3 * k + i] * axes[row][k] * wayM;
      }
    }
    for (int k = 0; k < 3; k++) {
      arm[k] -= axes[row][k] * wayM;
    }
  }

  private void turnBy(int row, double angleRad) {
    off[3 + row] -= angleRad;
    double[] along = new double[3];
    along[row] = angleRad;
    Rotations.vectorToMatrix(along[0], along[1], along[2], turn);
    double[] before = stand.clone();
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        stand[3 * i + j] =
            turn[3 * i] * before[j]
                + turn[3 * i + 1] * before[3 + j]
                + turn[3 * i + 2] * before[6 + j];
      }
    }
  }

  private static double turned(double[] pose, int row, double[] vector) {
    return pose[3 * row] * vector[0]
        + pose[3 * row + 1] * vector[1]
        + pose[3 * row + 2] * vector[2];
  }
}
