package org.pendant.models.pose;

/**
 * Conversions between the ways to write a rotation: rotation vector, matrix, unit quaternion, and
 * roll, pitch and yaw.
 *
 * <p>A matrix is a {@code double[]} whose first nine entries are its rows one after another; it
 * turns a vector given in the rotated frame into the reference frame. A quaternion is {@code (w, x,
 * y, z)}. Every method writes into its last parameter; only {@link #vectorToRpy} and {@link
 * #rpyToVector} allocate, the matrix they pass through. Input and output may be the same array.
 *
 * <p><b>Which vector of the many.</b> A rotation has infinitely many rotation vectors; the results
 * here have a length from 0 to pi. At pi the axis and its opposite mean the same rotation, and
 * rounding would choose between them; so within {@value #HALF_TURN_BAND} of w = 0 the axis is taken
 * whose first component beyond {@value #LEADING_COMPONENT} is positive. The vector may then be
 * longer than pi by at most twice that band, so that the rotation it stands for stays exact.
 *
 * <p>Formulas: J. Diebel, "Representing attitude: Euler angles, unit quaternions, and rotation
 * vectors" (2006), sections 5 to 7; the choice of the largest diagonal follows S. W. Shepperd,
 * "Quaternion from rotation matrix" (1978).
 */
public final class Rotations {
  /** Largest |w| of a unit quaternion that counts as half a turn; well above rounding, 1e-15. */
  static final double HALF_TURN_BAND = 1e-12;

  /** A component of a unit axis below this counts as zero when the sign of the axis is chosen. */
  static final double LEADING_COMPONENT = 1e-9;

  /** Below this angle (rad) series of two terms are exact in double precision. */
  private static final double SMALL_ANGLE = 1e-4;

  /**
   * Below this cosine of pitch, roll and yaw turn about the same axis and roll is taken as 0; the
   * rotation changes by no more than this angle in rad.
   */
  private static final double GIMBAL_LOCK = 1e-12;

  private Rotations() {}

  /** Rotation vector (rad) to matrix. */
  public static void vectorToMatrix(double rx, double ry, double rz, double[] matrix) {
    double angle = Math.sqrt(rx * rx + ry * ry + rz * rz);
    double s = halfSine(angle);
    quaternionToMatrix(Math.cos(0.5 * angle), s * rx, s * ry, s * rz, matrix);
  }

  /** Matrix to rotation vector (rad), in {@code vector[0..2]}. */
  public static void matrixToVector(double[] matrix, double[] vector) {
    double m00 = matrix[0];
    double m11 = matrix[4];
    double m22 = matrix[8];
    double w;
    double x;
    double y;
    double z;
    double trace = m00 + m11 + m22;
    if (trace >= m00 && trace >= m11 && trace >= m22) {
      w = 1 + trace;
      x = matrix[7] - matrix[5];
      y = matrix[2] - matrix[6];
      z = matrix[3] - matrix[1];
    } else if (m00 >= m11 && m00 >= m22) {
      w = matrix[7] - matrix[5];
      x = 1 + m00 - m11 - m22;
      y = matrix[1] + matrix[3];
      z = matrix[2] + matrix[6];
    } else if (m11 >= m22) {
      w = matrix[2] - matrix[6];
      x = matrix[1] + matrix[3];
      y = 1 - m00 + m11 - m22;
      z = matrix[5] + matrix[7];
    } else {
      w = matrix[3] - matrix[1];
      x = matrix[2] + matrix[6];
      y = matrix[5] + matrix[7];
      z = 1 - m00 - m11 + m22;
    }
    double scale = 1 / Math.sqrt(w * w + x * x + y * y + z * z);
    double f = vectorFactor(scale * w, scale * x, scale * y, scale * z) * scale;
    vector[0] = f * x;
    vector[1] = f * y;
    vector[2] = f * z;
  }

  /**
   * Matrix to unit quaternion, in {@code quaternion[0..3]}; w is not negative, except by less than
   * {@value #HALF_TURN_BAND} at half a turn.
   */
  public static void matrixToQuaternion(double[] matrix, double[] quaternion) {
    matrixToVector(matrix, quaternion);
    vectorToQuaternion(quaternion[0], quaternion[1], quaternion[2], quaternion);
  }

  /** Rotation vector (rad) to unit quaternion, in {@code quaternion[0..3]}. */
  public static void vectorToQuaternion(double rx, double ry, double rz, double[] quaternion) {
    double angle = Math.sqrt(rx * rx + ry * ry + rz * rz);
    double s = halfSine(angle);
    quaternion[0] = Math.cos(0.5 * angle);
    quaternion[1] = s * rx;
    quaternion[2] = s * ry;
    quaternion[3] = s * rz;
  }

  /** Unit quaternion to rotation vector (rad), in {@code vector[0..2]}. */
  public static void quaternionToVector(double w, double x, double y, double z, double[] vector) {
    double f = vectorFactor(w, x, y, z);
    vector[0] = f * x;
    vector[1] = f * y;
    vector[2] = f * z;
  }

  /** Unit quaternion to matrix. */
  public static void quaternionToMatrix(double w, double x, double y, double z, double[] matrix) {
    matrix[0] = 1 - 2 * (y * y + z * z);
    matrix[1] = 2 * (x * y - w * z);
    matrix[2] = 2 * (x * z + w * y);
    matrix[3] = 2 * (x * y + w * z);
    matrix[4] = 1 - 2 * (x * x + z * z);
    matrix[5] = 2 * (y * z - w * x);
    matrix[6] = 2 * (x * z - w * y);
    matrix[7] = 2 * (y * z + w * x);
    matrix[8] = 1 - 2 * (x * x + y * y);
  }

  /**
   * Roll, pitch and yaw (rad) to matrix: {@code Rz(yaw) Ry(pitch) Rx(roll)}, turns about the fixed
   * axes x, y, z in this order (manual 17.28).
   */
  public static void rpyToMatrix(double roll, double pitch, double yaw, double[] matrix) {
    double cr = Math.cos(roll);
    double sr = Math.sin(roll);
    double cp = Math.cos(pitch);
    double sp = Math.sin(pitch);
    double cy = Math.cos(yaw);
    double sy = Math.sin(yaw);
    matrix[0] = cy * cp;
    matrix[1] = cy * sp * sr - sy * cr;
    matrix[2] = cy * sp * cr + sy * sr;
    matrix[3] = sy * cp;
    matrix[4] = sy * sp * sr + cy * cr;
    matrix[5] = sy * sp * cr - cy * sr;
    matrix[6] = -sp;
    matrix[7] = cp * sr;
    matrix[8] = cp * cr;
  }

  /**
   * Matrix to roll, pitch and yaw (rad), in {@code rpy[0..2]}; pitch lies within ±pi/2. At pitch
   * ±pi/2 only the difference or sum of roll and yaw is defined: roll is 0 there.
   */
  public static void matrixToRpy(double[] matrix, double[] rpy) {
    double cosPitch = Math.hypot(matrix[7], matrix[8]);
    boolean locked = cosPitch < GIMBAL_LOCK;
    double sr = locked ? 0 : matrix[7] / cosPitch;
    double cr = locked ? 1 : matrix[8] / cosPitch;
    // yaw is taken from the rotation with roll undone, so it stays exact when cosPitch is tiny
    double yaw = Math.atan2(sr * matrix[2] - cr * matrix[1], cr * matrix[4] - sr * matrix[5]);
    rpy[1] = Math.atan2(-matrix[6], cosPitch);
    rpy[0] = Math.atan2(sr, cr);
    rpy[2] = yaw;
  }

  /** Rotation vector (rad) to roll, pitch and yaw (rad), in {@code rpy[0..2]} (manual 17.28). */
  public static void vectorToRpy(double rx, double ry, double rz, double[] rpy) {
    double[] matrix = new double[9];
    vectorToMatrix(rx, ry, rz, matrix);
    matrixToRpy(matrix, rpy);
  }

  /** Roll, pitch and yaw (rad) to rotation vector (rad), in {@code vector[0..2]} (manual 17.29). */
  public static void rpyToVector(double roll, double pitch, double yaw, double[] vector) {
    double[] matrix = new double[9];
    rpyToMatrix(roll, pitch, yaw, matrix);
    matrixToVector(matrix, vector);
  }

  /** sin(angle / 2) / angle: what turns a rotation vector into a quaternion's vector part. */
  static double halfSine(double angle) {
    return angle < SMALL_ANGLE ? 0.5 - angle * angle / 48 : Math.sin(0.5 * angle) / angle;
  }

  /** What turns the vector part of a unit quaternion into the rotation vector; may be negative. */
  static double vectorFactor(double w, double x, double y, double z) {
    boolean flip = Math.abs(w) > HALF_TURN_BAND ? w < 0 : !pointsForward(x, y, z);
    double cosine = flip ? -w : w;
    double squared = x * x + y * y + z * z;
    double factor;
    if (squared < 0.25 * SMALL_ANGLE * SMALL_ANGLE) {
      // 2 asin(n) / n: the quaternion is a unit one, so n alone tells a small angle
      factor = 2 + squared / 3;
    } else {
      double sine = Math.sqrt(squared);
      factor = 2 * Math.atan2(sine, cosine) / sine;
    }
    return flip ? -factor : factor;
  }

  private static boolean pointsForward(double x, double y, double z) {
    if (Math.abs(x) > LEADING_COMPONENT) {
      return x > 0;
    }
    return Math.abs(y) > LEADING_COMPONENT ? y > 0 : z > 0;
  }
}
