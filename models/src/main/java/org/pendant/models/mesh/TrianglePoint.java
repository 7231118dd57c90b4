package org.pendant.models.mesh;

/**
 * Triangle point: the point of a triangle that is nearest to a place. (C. Ericson: "Real-Time
 * Collision Detection", 5.1.5.)
 */
final class TrianglePoint {
  /** Where it is. */
  double x;

  double y;
  double z;

  /** What it is on: 0 the face, 1 to 3 an edge, 4 to 6 a corner. */
  int part;

  /** Finds it, for the triangle whose nine numbers begin at {@code at}. */
  void find(double[] corners, int at, double px, double py, double pz) {
    double ax = corners[at];
    double ay = corners[at + 1];
    double az = corners[at + 2];
    double abx = corners[at + 3] - ax;
    double aby = corners[at + 4] - ay;
    double abz = corners[at + 5] - az;
    double acx = corners[at + 6] - ax;
    double acy = corners[at + 7] - ay;
    double acz = corners[at + 8] - az;
    double d1 = abx * (px - ax) + aby * (py - ay) + abz * (pz - az);
    double d2 = acx * (px - ax) + acy * (py - ay) + acz * (pz - az);
    if (d1 <= 0 && d2 <= 0) {
      set(4, ax, ay, az);
      return;
    }
    double bx = px - corners[at + 3];
    double by = py - corners[at + 4];
    double bz = pz - corners[at + 5];
    double d3 = abx * bx + aby * by + abz * bz;
    double d4 = acx * bx + acy * by + acz * bz;
    if (d3 >= 0 && d4 <= d3) {
      set(5, corners[at + 3], corners[at + 4], corners[at + 5]);
      return;
    }
    double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) {
      double v = d1 - d3 > 0 ? d1 / (d1 - d3) : 0;
      set(1, ax + v * abx, ay + v * aby, az + v * abz);
      return;
    }
    double cx = px - corners[at + 6];
    double cy = py - corners[at + 7];
    double cz = pz - corners[at + 8];
    double d5 = abx * cx + aby * cy + abz * cz;
    double d6 = acx * cx + acy * cy + acz * cz;
    if (d6 >= 0 && d5 <= d6) {
      set(6, corners[at + 6], corners[at + 7], corners[at + 8]);
      return;
    }
    double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) {
      double w = d2 - d6 > 0 ? d2 / (d2 - d6) : 0;
      set(3, ax + w * acx, ay + w * acy, az + w * acz);
      return;
    }
    double va = d3 * d6 - d5 * d4;
    double bc = d4 - d3;
    double cb = d5 - d6;
    if (va <= 0 && bc >= 0 && cb >= 0) {
      double w = bc + cb > 0 ? bc / (bc + cb) : 0;
      set(
          2,
          corners[at + 3] + w * (acx - abx),
          corners[at + 4] + w * (acy - aby),
          corners[at + 5] + w * (acz - abz));
      return;
    }
    double sum = va + vb + vc;
    double v = vb / sum;
    double w = vc / sum;
    set(0, ax + v * abx + w * acx, ay + v * aby + w * acy, az + v * abz + w * acz);
  }

  private void set(int on, double atX, double atY, double atZ) {
    part = on;
    x = atX;
    y = atY;
    z = atZ;
  }
}
