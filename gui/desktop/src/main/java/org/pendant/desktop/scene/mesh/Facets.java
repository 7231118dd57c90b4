package org.pendant.desktop.scene.mesh;

import org.pendant.models.mesh.TriangleMesh;

/** Facets: the triangles of a file, round where they meet at a small angle, else with edges. */
final class Facets {
  /** Triangles that meet at less than about 30 degrees are meant to be round there. */
  private static final double ROUND_COSINE = 0.87;

  private final TriangleMesh mesh;

  /** Three numbers for each triangle. */
  private final double[] normals;

  /** The triangles around each point: those from {@code start} of it to that of the next one. */
  private final int[] start;

  private final int[] around;

  private Facets(TriangleMesh mesh) {
    this.mesh = mesh;
    normals = new double[3 * mesh.triangles()];
    start = new int[mesh.points() + 2];
    around = new int[3 * mesh.triangles()];
    for (int i = 0; i < mesh.triangles(); i++) {
      face(i);
      for (int corner = 0; corner < 3; corner++) {
        start[mesh.corner(i, corner) + 2]++;
      }
    }
    for (int i = 2; i < start.length; i++) {
      start[i] += start[i - 1];
    }
    for (int i = 0; i < around.length; i++) {
      around[start[mesh.corner(i / 3, i % 3) + 1]++] = i / 3;
    }
  }

  /**
   * Adds them to a mesh.
   *
   * @param coloured whether triangles have the colours of the file
   */
  static void add(MeshBuilder to, TriangleMesh mesh, boolean coloured) {
    Facets facets = new Facets(mesh);
    for (int i = 0; i < mesh.triangles(); i++) {
      to.colour(coloured ? mesh.rgb(i) : MeshBuilder.NO_COLOUR);
      int first = facets.vertex(to, i, 0);
      facets.vertex(to, i, 1);
      facets.vertex(to, i, 2);
      to.triangle(first, first + 1, first + 2);
    }
  }

  private int vertex(MeshBuilder to, int triangle, int corner) {
    int point = mesh.corner(triangle, corner);
    double nx = 0;
    double ny = 0;
    double nz = 0;
    for (int i = start[point]; i < start[point + 1]; i++) {
      int other = 3 * around[i];
      if (dot(3 * triangle, other) > ROUND_COSINE) {
        nx += normals[other];
        ny += normals[other + 1];
        nz += normals[other + 2];
      }
    }
    boolean none = nx == 0 && ny == 0 && nz == 0;
    return to.vertex(
        (float) mesh.coordinate(point, 0),
        (float) mesh.coordinate(point, 1),
        (float) mesh.coordinate(point, 2),
        (float) nx,
        (float) ny,
        none ? 1 : (float) nz);
  }

  private double dot(int one, int other) {
    return normals[one] * normals[other]
        + normals[one + 1] * normals[other + 1]
        + normals[one + 2] * normals[other + 2];
  }

  private void face(int triangle) {
    double[] one = new double[3];
    double[] other = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      double from = mesh.coordinate(mesh.corner(triangle, 0), axis);
      one[axis] = mesh.coordinate(mesh.corner(triangle, 1), axis) - from;
      other[axis] = mesh.coordinate(mesh.corner(triangle, 2), axis) - from;
    }
    double x = one[1] * other[2] - one[2] * other[1];
    double y = one[2] * other[0] - one[0] * other[2];
    double z = one[0] * other[1] - one[1] * other[0];
    double length = Math.sqrt(x * x + y * y + z * z);
    if (length > 0) {
      normals[3 * triangle] = x / length;
      normals[3 * triangle + 1] = y / length;
      normals[3 * triangle + 2] = z / length;
    }
  }
}
