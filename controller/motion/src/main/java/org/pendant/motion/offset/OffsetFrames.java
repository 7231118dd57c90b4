package org.pendant.motion.offset;

import java.util.Arrays;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;

/**
 * Offset frames: applies an offset given in one of the frames to a TCP, and expresses it in
 * another.
 */
final class OffsetFrames {
  private final MotionFrame along;
  private final double[] path = new double[Transforms.SIZE];
  private final double[] target = new double[Transforms.SIZE];
  private final double[] offset = new double[Transforms.SIZE];
  private final double[] scratch = new double[Transforms.SIZE];
  private final double[] vector = new double[3];
  private boolean laid;

  OffsetFrames(MotionFrame along) {
    this.along = along;
  }

  /** Nothing is laid over anything. */
  void forget() {
    laid = false;
  }

  /** A frame begins in which nothing is laid over a TCP yet. */
  void begin(double[] tcpInBase) {
    System.arraycopy(tcpInBase, 0, path, 0, Transforms.SIZE);
    System.arraycopy(tcpInBase, 0, target, 0, Transforms.SIZE);
    laid = true;
  }

  /**
   * Lays an offset over the TCP of {@link #begin}.
   *
   * @param six shift in m and rotation vector in rad
   */
  void lay(OffsetType type, double[] six, double[] tcpInBase) {
    switch (type) {
      case BASE -> {
        Rotations.vectorToMatrix(six[3], six[4], six[5], offset);
        Turns.multiply(offset, path, tcpInBase);
        shift(six[0], six[1], six[2], tcpInBase);
      }
      case TCP -> {
        transform(six);
        Transforms.multiply(path, offset, tcpInBase);
      }
      case MOTION -> {
        double[] f = along.rotation();
        Rotations.vectorToMatrix(
            f[0] * six[3] + f[1] * six[4] + f[2] * six[5],
            f[3] * six[3] + f[4] * six[4] + f[5] * six[5],
            f[6] * six[3] + f[7] * six[4] + f[8] * six[5],
            offset);
        Turns.multiply(offset, path, tcpInBase);
        shift(
            f[0] * six[0] + f[1] * six[1] + f[2] * six[2],
            f[3] * six[0] + f[4] * six[1] + f[5] * six[2],
            f[6] * six[0] + f[7] * six[1] + f[8] * six[2],
            tcpInBase);
      }
      case WORLD -> {
        transform(six);
        Transforms.invert(offset, scratch);
        Transforms.multiply(scratch, path, tcpInBase);
      }
    }
    System.arraycopy(tcpInBase, 0, target, 0, Transforms.SIZE);
  }

  private void transform(double[] six) {
    Rotations.vectorToMatrix(six[3], six[4], six[5], offset);
    System.arraycopy(six, 0, offset, 9, 3);
  }

  private void shift(double x, double y, double z, double[] tcpInBase) {
    tcpInBase[9] = path[9] + x;
    tcpInBase[10] = path[10] + y;
    tcpInBase[11] = path[11] + z;
  }

  /**
   * What is laid over the TCP, as it would have to be given in a frame; 0 along a path that has had
   * no direction yet.
   *
   * @param six overwritten
   */
  void applied(OffsetType type, double[] six) {
    Arrays.fill(six, 0);
    if (!laid) {
      return;
    }
    double x = target[9] - path[9];
    double y = target[10] - path[10];
    double z = target[11] - path[11];
    switch (type) {
      case BASE -> {
        turnInBase();
        six[0] = x;
        six[1] = y;
        six[2] = z;
        System.arraycopy(vector, 0, six, 3, 3);
      }
      case TCP -> {
        Transforms.invert(path, scratch);
        Transforms.multiply(scratch, target, offset);
        ofTransform(six);
      }
      case MOTION -> {
        if (along.known()) {
          turnInBase();
          Turns.turnBack(along.rotation(), vector[0], vector[1], vector[2], scratch);
          System.arraycopy(scratch, 0, six, 3, 3);
          Turns.turnBack(along.rotation(), x, y, z, scratch);
          System.arraycopy(scratch, 0, six, 0, 3);
        }
      }
      case WORLD -> {
        Transforms.invert(target, scratch);
        Transforms.multiply(path, scratch, offset);
        ofTransform(six);
      }
    }
  }

  private void turnInBase() {
    Turns.multiplyTransposed(target, path, offset);
    Rotations.matrixToVector(offset, vector);
  }

  private void ofTransform(double[] six) {
    Rotations.matrixToVector(offset, vector);
    System.arraycopy(offset, 9, six, 0, 3);
    System.arraycopy(vector, 0, six, 3, 3);
  }
}
