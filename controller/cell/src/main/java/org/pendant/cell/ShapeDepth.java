package org.pendant.cell;

import org.pendant.models.mesh.ConvexHull;

/** Shape depth: how deep a point is in a shape, along its own axes. */
final class ShapeDepth {
  private ShapeDepth() {}

  /**
   * The depth, m; at most 0 outside.
   *
   * @param out3 overwritten with the direction of the shortest way out, where the point is inside
   */
  static double of(BodyShape shape, double x, double y, double z, double[] out3) {
    return switch (shape) {
      case BodyShape.Box(double sizeX, double sizeY, double sizeZ) -> {
        double dx = sizeX / 2 - Math.abs(x);
        double dy = sizeY / 2 - Math.abs(y);
        double dz = sizeZ / 2 - Math.abs(z);
        double least = Math.min(dx, Math.min(dy, dz));
        int axis = dz == least ? 2 : dy == least ? 1 : 0;
        set(out3, axis == 0 ? side(x) : 0, axis == 1 ? side(y) : 0, axis == 2 ? side(z) : 0);
        yield least;
      }
      case BodyShape.Sphere(double r) -> round(r, x, y, z, out3);
      case BodyShape.Capsule(double r, double length) ->
          round(r, x, y, z - Math.max(-length / 2, Math.min(length / 2, z)), out3);
      case BodyShape.Cylinder(double r, double length) -> {
        double toEnd = length / 2 - Math.abs(z);
        double toMantle = round(r, x, y, 0, out3);
        if (toEnd < toMantle) {
          set(out3, 0, 0, side(z));
        }
        yield Math.min(toEnd, toMantle);
      }
      case BodyShape.Hull hull -> inHull(hull.hull(), x, y, z, out3);
      case BodyShape.HalfSpace _, BodyShape.Faces _, BodyShape.Compound _ -> 0;
    };
  }

  private static double inHull(ConvexHull hull, double x, double y, double z, double[] out3) {
    double least = Double.POSITIVE_INFINITY;
    for (int face = 0; face < hull.faces(); face++) {
      double nx = hull.plane(face, 0);
      double ny = hull.plane(face, 1);
      double nz = hull.plane(face, 2);
      double depth = hull.plane(face, 3) - nx * x - ny * y - nz * z;
      if (depth < least) {
        least = depth;
        set(out3, nx, ny, nz);
        if (depth <= 0) {
          return depth;
        }
      }
    }
    return least;
  }

  private static double round(double r, double x, double y, double z, double[] out3) {
    double away = Math.sqrt(x * x + y * y + z * z);
    if (away > 0) {
      set(out3, x / away, y / away, z / away);
    } else {
      set(out3, 1, 0, 0);
    }
    return r - away;
  }

  private static double side(double x) {
    return x < 0 ? -1 : 1;
  }

  private static void set(double[] vector, double x, double y, double z) {
    vector[0] = x;
    vector[1] = y;
    vector[2] = z;
  }
}
