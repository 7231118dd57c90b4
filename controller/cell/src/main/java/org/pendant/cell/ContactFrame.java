package org.pendant.cell;

/** Contact frame: a place, the normal of a contact as z, and two directions across it. */
final class ContactFrame {
  /** Three numbers each, along the base's axes. */
  final double[] origin = new double[3];

  final double[] normal = new double[3];
  final double[] tangent1 = new double[3];
  final double[] tangent2 = new double[3];

  /** Sets the normal, of length 1, and the others with it. */
  void set(double[] pose12, double nx, double ny, double nz) {
    origin[0] = pose12[9];
    origin[1] = pose12[10];
    origin[2] = pose12[11];
    put(normal, nx, ny, nz);
    across(normal, tangent1, tangent2);
  }

  /** Two directions at right angles to a normal, that turn steadily with it. */
  static void across(double[] normal, double[] tangent1, double[] tangent2) {
    double x = normal[0];
    double y = normal[1];
    double z = normal[2];
    if (Math.abs(z) > 0.7) {
      double length = Math.sqrt(y * y + z * z);
      put(tangent1, 0, -z / length, y / length);
    } else {
      double length = Math.sqrt(x * x + y * y);
      put(tangent1, -y / length, x / length, 0);
    }
    put(
        tangent2,
        y * tangent1[2] - z * tangent1[1],
        z * tangent1[0] - x * tangent1[2],
        x * tangent1[1] - y * tangent1[0]);
  }

  private static void put(double[] vector, double x, double y, double z) {
    vector[0] = x;
    vector[1] = y;
    vector[2] = z;
  }
}
