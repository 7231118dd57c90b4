package org.pendant.cell;

import java.util.Arrays;
import org.pendant.models.mesh.ConvexHull;
import org.pendant.models.mesh.MeshDistance;
import org.pendant.models.pose.Transforms;

/**
 * Polyhedron: a convex solid with corners where a body is now. For one thread at a time; nothing is
 * allocated once it was made.
 */
final class Polyhedron {
  /** An edge is sharp if its faces lean over each other by more, as a sine. */
  private static final double SHARP = 1e-3;

  /** What is so near a face is within, m. */
  private static final double ON_FACE_M = 1e-9;

  final ConvexHull hull;

  /** Its corners in the base frame, m, three numbers each. */
  final double[] points;

  /** The planes of its faces there: three of the direction out, and how far out they are, m. */
  final double[] planes;

  /** Edges: two corners and two faces each. */
  final int[] edges;

  /** The corners of all faces, one face after the other. */
  final int[] corners;

  /** Where the corners of a face begin; one more at the end. */
  final int[] firstCorner;

  /** Whether the solid does not become narrower behind a face: its neighbours are not sharp. */
  final boolean[] upright;

  /** The box around it along the axes of the base: least, then most, m. */
  final double[] box6 = new double[6];

  /** A ball of this radius around its origin is within it, m. */
  final double innerM;

  /** Where it is, as {@link Transforms} has it; whoever has the body changes it. */
  final double[] pose;

  /** Corners and planes along its own axes. */
  private final double[] own;

  private final double[] ownPlanes;
  private final double[] was = new double[Transforms.SIZE];
  private MeshDistance distance;
  private int lowest;

  /**
   * A solid at a pose.
   *
   * @param hull its shape; the origin is inside
   */
  Polyhedron(ConvexHull hull, double[] pose) {
    this.hull = hull;
    this.pose = pose;
    points = new double[3 * hull.points()];
    planes = new double[4 * hull.faces()];
    own = new double[points.length];
    for (int i = 0; i < own.length; i++) {
      own[i] = hull.coordinate(i / 3, i % 3);
    }
    ownPlanes = new double[planes.length];
    for (int i = 0; i < ownPlanes.length; i++) {
      ownPlanes[i] = hull.plane(i / 4, i % 4);
    }
    edges = new int[4 * hull.edges()];
    for (int i = 0; i < edges.length; i++) {
      edges[i] = hull.edge(i / 4, i % 4);
    }
    upright = upright();
    firstCorner = new int[hull.faces() + 1];
    double inner = Double.POSITIVE_INFINITY;
    for (int face = 0; face < hull.faces(); face++) {
      firstCorner[face + 1] = firstCorner[face] + hull.corners(face);
      inner = Math.min(inner, hull.plane(face, 3));
    }
    innerM = Math.max(0, inner);
    corners = new int[firstCorner[hull.faces()]];
    for (int face = 0; face < hull.faces(); face++) {
      for (int i = 0; i < hull.corners(face); i++) {
        corners[firstCorner[face] + i] = hull.corner(face, i);
      }
    }
    was[0] = Double.NaN;
  }

  private boolean[] upright() {
    boolean[] upright = new boolean[hull.faces()];
    Arrays.fill(upright, true);
    for (int i = 0; i < edges.length; i += 4) {
      int a = 4 * edges[i + 2];
      int b = 4 * edges[i + 3];
      double cosine = 0;
      for (int k = 0; k < 3; k++) {
        cosine += ownPlanes[a + k] * ownPlanes[b + k];
      }
      if (cosine < -SHARP) {
        upright[a / 4] = false;
        upright[b / 4] = false;
      }
    }
    return upright;
  }

  /** Brings all places up to the pose. */
  void follow() {
    boolean same = true;
    for (int i = 0; i < Transforms.SIZE; i++) {
      same &= was[i] == pose[i];
    }
    if (same) {
      return;
    }
    System.arraycopy(pose, 0, was, 0, Transforms.SIZE);
    turnPoints();
    turnPlanes();
  }

  private void turnPoints() {
    double[] p = pose;
    for (int i = 0; i < own.length; i += 3) {
      double x = own[i];
      double y = own[i + 1];
      double z = own[i + 2];
      points[i] = p[9] + p[0] * x + p[1] * y + p[2] * z;
      points[i + 1] = p[10] + p[3] * x + p[4] * y + p[5] * z;
      points[i + 2] = p[11] + p[6] * x + p[7] * y + p[8] * z;
    }
    for (int row = 0; row < 3; row++) {
      double least = points[row];
      double most = least;
      for (int i = row; i < points.length; i += 3) {
        double at = points[i];
        if (at < least) {
          least = at;
        } else if (at > most) {
          most = at;
        }
      }
      box6[row] = least;
      box6[3 + row] = most;
    }
  }

  private void turnPlanes() {
    double[] p = pose;
    for (int at = 0; at < planes.length; at += 4) {
      double x = ownPlanes[at];
      double y = ownPlanes[at + 1];
      double z = ownPlanes[at + 2];
      double alongX = p[0] * x + p[1] * y + p[2] * z;
      double alongY = p[3] * x + p[4] * y + p[5] * z;
      double alongZ = p[6] * x + p[7] * y + p[8] * z;
      planes[at] = alongX;
      planes[at + 1] = alongY;
      planes[at + 2] = alongZ;
      planes[at + 3] = ownPlanes[at + 3] + alongX * p[9] + alongY * p[10] + alongZ * p[11];
    }
  }

  int faces() {
    return hull.faces();
  }

  /** How far a place of the base is out of a face, m. */
  double out(int face, double x, double y, double z) {
    int at = 4 * face;
    return planes[at] * x + planes[at + 1] * y + planes[at + 2] * z - planes[at + 3];
  }

  /** How far a place is out of each face, m. */
  void outs(double x, double y, double z, double[] outs) {
    double[] p = planes;
    for (int face = 0, at = 0; at < p.length; face++, at += 4) {
      outs[face] = p[at] * x + p[at + 1] * y + p[at + 2] * z - p[at + 3];
    }
  }

  /** Whether a place of the base is within it, or nearly. */
  boolean holds(double x, double y, double z) {
    double[] p = planes;
    for (int at = 0; at < p.length; at += 4) {
      if (p[at] * x + p[at + 1] * y + p[at + 2] * z - p[at + 3] > ON_FACE_M) {
        return false;
      }
    }
    return true;
  }

  /** The face that is most against a direction. */
  int against(double[] along3) {
    double[] p = planes;
    double x = along3[0];
    double y = along3[1];
    double z = along3[2];
    double least = Double.POSITIVE_INFINITY;
    int found = 0;
    for (int at = 0; at < p.length; at += 4) {
      double along = x * p[at] + y * p[at + 1] + z * p[at + 2];
      if (along < least) {
        least = along;
        found = at / 4;
      }
    }
    return found;
  }

  /** How far out of one of some planes its lowest corner is, m. */
  double least(double[] of, int plane) {
    double[] p = points;
    double x = of[4 * plane];
    double y = of[4 * plane + 1];
    double z = of[4 * plane + 2];
    double least = Double.POSITIVE_INFINITY;
    for (int i = 0; i < p.length; i += 3) {
      double along = x * p[i] + y * p[i + 1] + z * p[i + 2];
      if (along < least) {
        least = along;
        lowest = i;
      }
    }
    return least - of[4 * plane + 3];
  }

  /** Where in {@link #points} the corner is that is least along a direction. */
  int lowest(double[] along3) {
    double[] p = points;
    int found = 0;
    for (int i = 3; i < p.length; i += 3) {
      if (along3[0] * (p[i] - p[found])
              + along3[1] * (p[i + 1] - p[found + 1])
              + along3[2] * (p[i + 2] - p[found + 2])
          < 0) {
        found = i;
      }
    }
    return found;
  }

  /** How far out of a plane the corner is that was the lowest of the latest plane, m. */
  double lowestOut(double[] of, int plane) {
    int at = 4 * plane;
    return of[at] * points[lowest]
        + of[at + 1] * points[lowest + 1]
        + of[at + 2] * points[lowest + 2]
        - of[at + 3];
  }

  /**
   * How far a place of the base is away, m: below 0 by the depth inside.
   *
   * @param out3 overwritten with the direction out of it there, in the base
   */
  double away(double x, double y, double z, double[] out3) {
    if (distance == null) {
      distance = new MeshDistance(hull.surface());
    }
    double dx = x - pose[9];
    double dy = y - pose[10];
    double dz = z - pose[11];
    double away =
        distance.toPoint(
            pose[0] * dx + pose[3] * dy + pose[6] * dz,
            pose[1] * dx + pose[4] * dy + pose[7] * dz,
            pose[2] * dx + pose[5] * dy + pose[8] * dz,
            out3);
    double ox = out3[0];
    double oy = out3[1];
    double oz = out3[2];
    for (int row = 0; row < 3; row++) {
      out3[row] = pose[3 * row] * ox + pose[3 * row + 1] * oy + pose[3 * row + 2] * oz;
    }
    return away;
  }

  /** How far a ray goes until it enters it, m; infinite where it does not, or begins inside. */
  double enters(double[] from3, double[] along3, double lengthM) {
    follow();
    double in = Double.NEGATIVE_INFINITY;
    double out = lengthM;
    for (int face = 0; face < faces(); face++) {
      int at = 4 * face;
      double height = out(face, from3[0], from3[1], from3[2]);
      double slope =
          planes[at] * along3[0] + planes[at + 1] * along3[1] + planes[at + 2] * along3[2];
      if (slope == 0 && height > 0) {
        return Double.POSITIVE_INFINITY;
      } else if (slope < 0) {
        in = Math.max(in, -height / slope);
      } else if (slope > 0) {
        out = Math.min(out, -height / slope);
      }
    }
    return in >= 0 && in <= out ? in : Double.POSITIVE_INFINITY;
  }
}
