package org.pendant.models.pose;

import java.util.Random;
import org.ejml.simple.SimpleMatrix;

/** Random poses, and an independent way from a pose to its homogeneous matrix. */
final class Samples {
  private Samples() {}

  /** A position within 2 m and a rotation vector shorter than 3 rad in random direction. */
  static Pose pose(Random random) {
    double[] axis = axis(random);
    double angle = 3 * random.nextDouble();
    return new Pose(
        4 * random.nextDouble() - 2,
        4 * random.nextDouble() - 2,
        4 * random.nextDouble() - 2,
        angle * axis[0],
        angle * axis[1],
        angle * axis[2]);
  }

  /** A unit vector in random direction. */
  static double[] axis(Random random) {
    double x = random.nextGaussian();
    double y = random.nextGaussian();
    double z = random.nextGaussian();
    double norm = Math.sqrt(x * x + y * y + z * z);
    return new double[] {x / norm, y / norm, z / norm};
  }

  /** Rodrigues' formula with matrices: {@code I + sin K + (1 - cos) K K}. */
  static SimpleMatrix rotation(double rx, double ry, double rz) {
    double angle = Math.sqrt(rx * rx + ry * ry + rz * rz);
    if (angle == 0) {
      return SimpleMatrix.identity(3);
    }
    SimpleMatrix k =
        new SimpleMatrix(new double[][] {{0, -rz, ry}, {rz, 0, -rx}, {-ry, rx, 0}}).divide(angle);
    return SimpleMatrix.identity(3)
        .plus(k.scale(StrictMath.sin(angle)))
        .plus(k.mult(k).scale(1 - StrictMath.cos(angle)));
  }

  static SimpleMatrix matrix(Pose p) {
    SimpleMatrix matrix = SimpleMatrix.identity(4);
    matrix.insertIntoThis(0, 0, rotation(p.rx(), p.ry(), p.rz()));
    matrix.set(0, 3, p.x());
    matrix.set(1, 3, p.y());
    matrix.set(2, 3, p.z());
    return matrix;
  }

  static SimpleMatrix matrix(double[] transform) {
    SimpleMatrix matrix = SimpleMatrix.identity(4);
    for (int row = 0; row < 3; row++) {
      for (int column = 0; column < 3; column++) {
        matrix.set(row, column, transform[3 * row + column]);
      }
      matrix.set(row, 3, transform[9 + row]);
    }
    return matrix;
  }
}
