package org.pendant.models.mesh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.pendant.models.pose.Transforms;

/**
 * Convex hull: the smallest solid without dents around points, with at most {@value #MAX_POINTS}
 * corners. Faces are polygons, counter-clockwise as seen from outside; triangles that are nearly in
 * one plane are one face. Immutable; lengths in m.
 */
public final class ConvexHull {
  /**
   * Corners at most. Points that stick out of the hull of others by least are left out: of a ball
   * it misses up to 4 % of the radius, of a cylinder of 100 sides nothing.
   */
  public static final int MAX_POINTS = 128;

  private final double[] points;
  private final int[][] faces;
  private final int[][] edges;
  private final double[] planes;

  private ConvexHull(double[] points, int[][] faces, int[][] edges) {
    this.points = points;
    this.faces = faces;
    this.edges = edges;
    planes = planes();
  }

  /**
   * The hull of points.
   *
   * @param points three coordinates each, m
   * @throws MeshException if all are nearly in one plane
   */
  public static ConvexHull of(double[] points) throws MeshException {
    HullFaces found = new HullFaces(points, new HullTriangles(points, MAX_POINTS).corners());
    return new ConvexHull(found.points(), found.faces(), found.edges());
  }

  /** A block around the origin, its lengths along x, y and z in m. */
  public static ConvexHull block(double x, double y, double z) {
    double[] points = new double[24];
    for (int i = 0; i < 8; i++) {
      points[3 * i] = ((i & 1) - 0.5) * x;
      points[3 * i + 1] = ((i >> 1 & 1) - 0.5) * y;
      points[3 * i + 2] = ((i >> 2) - 0.5) * z;
    }
    return made(
        points,
        List.of(
            new int[] {0, 2, 3, 1},
            new int[] {4, 5, 7, 6},
            new int[] {0, 1, 5, 4},
            new int[] {2, 6, 7, 3},
            new int[] {0, 4, 6, 2},
            new int[] {1, 3, 7, 5}));
  }

  /** A prism around the origin along z, with corners on a circle; lengths in m. */
  public static ConvexHull prism(int sides, double radiusM, double lengthM) {
    double[] points = new double[6 * sides];
    List<int[]> faces = new ArrayList<>(List.of(new int[sides], new int[sides]));
    for (int i = 0; i < sides; i++) {
      int next = (i + 1) % sides;
      for (int end = 0; end < 2; end++) {
        points[6 * i + 3 * end] = radiusM * Math.cos(2 * Math.PI * i / sides);
        points[6 * i + 3 * end + 1] = radiusM * Math.sin(2 * Math.PI * i / sides);
        points[6 * i + 3 * end + 2] = (end - 0.5) * lengthM;
      }
      faces.get(0)[sides - 1 - i] = 2 * i;
      faces.get(1)[i] = 2 * i + 1;
      faces.add(new int[] {2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    }
    return made(points, faces);
  }

  private static ConvexHull made(double[] points, List<int[]> faces) {
    return new ConvexHull(points, faces.toArray(int[][]::new), HullFaces.edges(faces));
  }

  /** The hull of a mesh. */
  static ConvexHull of(TriangleMesh mesh) throws MeshException {
    double[] points = new double[3 * mesh.points()];
    for (int i = 0; i < points.length; i++) {
      points[i] = mesh.coordinate(i / 3, i % 3);
    }
    return of(points);
  }

  /**
   * The same hull, as one sees it from elsewhere.
   *
   * @param frame12 where that is in the frame of this one, as {@link Transforms} has it
   */
  public ConvexHull seenFrom(double[] frame12) {
    double[] seen = new double[points.length];
    for (int i = 0; i < points.length; i += 3) {
      double x = points[i] - frame12[9];
      double y = points[i + 1] - frame12[10];
      double z = points[i + 2] - frame12[11];
      for (int axis = 0; axis < 3; axis++) {
        seen[i + axis] = frame12[axis] * x + frame12[3 + axis] * y + frame12[6 + axis] * z;
      }
    }
    return new ConvexHull(seen, faces, edges);
  }

  /** How many corners it has. */
  public int points() {
    return points.length / 3;
  }

  /**
   * A coordinate of a corner, m.
   *
   * @param axis 0 to 2
   */
  public double coordinate(int point, int axis) {
    return points[3 * point + axis];
  }

  /** How many faces it has. */
  public int faces() {
    return faces.length;
  }

  /** How many corners a face has. */
  public int corners(int face) {
    return faces[face].length;
  }

  /** The number of a corner of a face. */
  public int corner(int face, int corner) {
    return faces[face][corner];
  }

  /** The plane of a face: three of its direction out, of length 1, and how far it is out, m. */
  public double plane(int face, int index) {
    return planes[4 * face + index];
  }

  /** How many edges it has. */
  public int edges() {
    return edges.length;
  }

  /** Of an edge: its two corners, and the faces on both sides of it. */
  public int edge(int edge, int index) {
    return edges[edge][index];
  }

  /** How far its farthest corner is from the origin, m. */
  public double reachM() {
    double square = 0;
    for (int i = 0; i < points.length; i += 3) {
      square =
          Math.max(
              square,
              points[i] * points[i]
                  + points[i + 1] * points[i + 1]
                  + points[i + 2] * points[i + 2]);
    }
    return Math.sqrt(square);
  }

  /** How long it is along an axis, m. */
  public double lengthM(int axis) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = axis; i < points.length; i += 3) {
      least = Math.min(least, points[i]);
      most = Math.max(most, points[i]);
    }
    return most - least;
  }

  /** Its surface, of triangles. */
  public TriangleMesh surface() {
    List<Integer> corners = new ArrayList<>();
    for (int[] face : faces) {
      for (int i = 2; i < face.length; i++) {
        corners.addAll(List.of(face[0], face[i - 1], face[i]));
      }
    }
    int[] none = new int[corners.size() / 3];
    Arrays.fill(none, TriangleMesh.NO_COLOUR);
    return new TriangleMesh(points, corners.stream().mapToInt(Integer::intValue).toArray(), none);
  }

  /** The directions of the faces, by M. Newell's sums, and how far out they are. */
  private double[] planes() {
    double[] found = new double[4 * faces.length];
    for (int f = 0; f < faces.length; f++) {
      int[] face = faces[f];
      double[] n = new double[3];
      for (int i = 0; i < face.length; i++) {
        int a = 3 * face[i];
        int b = 3 * face[(i + 1) % face.length];
        for (int axis = 0; axis < 3; axis++) {
          int y = (axis + 1) % 3;
          int z = (axis + 2) % 3;
          n[axis] += (points[a + y] - points[b + y]) * (points[a + z] + points[b + z]);
        }
      }
      double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
      double out = Double.NEGATIVE_INFINITY;
      for (int i = 0; i < points.length; i += 3) {
        out =
            Math.max(
                out, (n[0] * points[i] + n[1] * points[i + 1] + n[2] * points[i + 2]) / length);
      }
      for (int axis = 0; axis < 3; axis++) {
        found[4 * f + axis] = n[axis] / length;
      }
      found[4 * f + 3] = out;
    }
    return found;
  }

  @Override
  public boolean equals(Object other) {
    return other == this
        || (other instanceof ConvexHull hull
            && Arrays.equals(points, hull.points)
            && Arrays.deepEquals(faces, hull.faces));
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(points) + Arrays.deepHashCode(faces);
  }

  @Override
  public String toString() {
    return points() + " corners, " + faces() + " faces";
  }
}
