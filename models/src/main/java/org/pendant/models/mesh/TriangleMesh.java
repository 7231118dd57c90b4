package org.pendant.models.mesh;

import java.util.Arrays;

/**
 * Triangle mesh: the surface of a solid, made of triangles that are counter-clockwise as seen from
 * outside. It is closed: each edge of a triangle is one of another triangle, in the other
 * direction. Immutable; lengths in m.
 */
public final class TriangleMesh {
  /** Triangles at most: a machine's housing has fewer, and its picture stays quick. */
  public static final int MAX_TRIANGLES = 100_000;

  /** No mesh is longer, m. */
  public static final double MAX_LENGTH_M = 10;

  /** No mesh is shorter along its longest side, m. */
  public static final double MIN_LENGTH_M = 0.001;

  /** What a triangle without a colour of its own has for one. */
  public static final int NO_COLOUR = -1;

  private final double[] points;
  private final int[] corners;
  private final int[] colours;
  private final double volumeM3;
  private MeshTree tree;
  private ConvexHull hull;
  private SolidMass mass;

  /**
   * Takes over all.
   *
   * @param points three coordinates each
   * @param corners three numbers of points for each triangle
   * @param colours of each triangle, as screens have them, or {@link #NO_COLOUR}
   */
  TriangleMesh(double[] points, int[] corners, int[] colours) {
    this.points = points;
    this.corners = corners;
    this.colours = colours;
    volumeM3 = volume(points, corners);
  }

  /** How many points there are. */
  public int points() {
    return points.length / 3;
  }

  /** How many triangles there are. */
  public int triangles() {
    return corners.length / 3;
  }

  /**
   * The number of a point of a triangle.
   *
   * @param corner 0 to 2
   */
  public int corner(int triangle, int corner) {
    return corners[3 * triangle + corner];
  }

  /**
   * A coordinate of a point, m.
   *
   * @param axis 0 to 2
   */
  public double coordinate(int point, int axis) {
    return points[3 * point + axis];
  }

  /** The colour of a triangle as screens have it, 0xRRGGBB; {@link #NO_COLOUR} for none. */
  public int rgb(int triangle) {
    return colours[triangle];
  }

  /** The least coordinate along an axis, m. */
  public double least(int axis) {
    double least = Double.POSITIVE_INFINITY;
    for (int i = axis; i < points.length; i += 3) {
      least = Math.min(least, points[i]);
    }
    return least;
  }

  /** The largest coordinate along an axis, m. */
  public double most(int axis) {
    double most = Double.NEGATIVE_INFINITY;
    for (int i = axis; i < points.length; i += 3) {
      most = Math.max(most, points[i]);
    }
    return most;
  }

  /** How far its farthest point is from the origin, m. */
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

  /** What it fills, m^3; above 0. */
  public double volumeM3() {
    return volumeM3;
  }

  /** Boxes around its triangles, made when they are asked for first. Any thread may ask. */
  synchronized MeshTree tree() {
    if (tree == null) {
      tree = new MeshTree(this);
    }
    return tree;
  }

  /**
   * The convex hull of its points, made when it is asked for first. Any thread may ask.
   *
   * @throws MeshException if it is flat
   */
  public synchronized ConvexHull hull() throws MeshException {
    if (hull == null) {
      hull = ConvexHull.of(this);
    }
    return hull;
  }

  /**
   * How its mass is spread, if it is the same everywhere; reckoned when it is asked for first. Any
   * thread may ask.
   *
   * @throws MeshException if it goes through itself
   */
  public synchronized SolidMass mass() throws MeshException {
    if (mass == null) {
      mass = new SolidMass(this);
    }
    return mass;
  }

  /** The sum of what is between a point and each triangle; below 0 for one that is inside out. */
  static double volume(double[] points, int[] corners) {
    double six = 0;
    double ox = points[0];
    double oy = points[1];
    double oz = points[2];
    for (int i = 0; i < corners.length; i += 3) {
      int a = 3 * corners[i];
      int b = 3 * corners[i + 1];
      int c = 3 * corners[i + 2];
      double bx = points[b] - ox;
      double by = points[b + 1] - oy;
      double bz = points[b + 2] - oz;
      double cx = points[c] - ox;
      double cy = points[c + 1] - oy;
      double cz = points[c + 2] - oz;
      six +=
          (points[a] - ox) * (by * cz - bz * cy)
              + (points[a + 1] - oy) * (bz * cx - bx * cz)
              + (points[a + 2] - oz) * (bx * cy - by * cx);
    }
    return six / 6;
  }

  @Override
  public boolean equals(Object other) {
    return other == this
        || (other instanceof TriangleMesh mesh
            && Arrays.equals(points, mesh.points)
            && Arrays.equals(corners, mesh.corners)
            && Arrays.equals(colours, mesh.colours));
  }

  @Override
  public int hashCode() {
    return 31 * Arrays.hashCode(points) + Arrays.hashCode(corners);
  }

  @Override
  public String toString() {
    return triangles() + " triangles";
  }
}
