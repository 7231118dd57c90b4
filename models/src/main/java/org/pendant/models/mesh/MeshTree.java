package org.pendant.models.mesh;

import java.util.HashMap;
import java.util.Map;

/**
 * Mesh tree: boxes around the triangles of a mesh, within one another, and which way its surface
 * faces. Immutable.
 *
 * <p>On edges and at points the surface faces as J. A. Baerentzen and H. Aanaes have it, "Signed
 * Distance Computation Using the Angle Weighted Pseudonormal" (2005): then the side of the nearest
 * place tells whether a point is inside.
 */
final class MeshTree {
  /** Numbers of a box: the least and the largest coordinates. */
  static final int BOX = 6;

  /** Numbers of the normals of a triangle: of its face, its three edges and its three corners. */
  static final int NORMALS = 21;

  private static final int LEAF = 4;

  /**
   * Triangles thinner than this have no direction: twice the area over the longest edge squared.
   */
  private static final double THIN = 1e-9;

  /** Corners of the triangles, nine numbers each, in the order of the leaves. */
  final double[] corners;

  /** Where the triangles face; see {@link #NORMALS}. */
  final double[] normals;

  /** For each corner whether it is the first one at its point, so that each point is told once. */
  final boolean[] owned;

  /** The boxes of nodes; the first child of a node is the next one. */
  final double[] boxes;

  /** The second child of each node; 0 for a leaf. */
  final int[] second;

  /** The first triangle of a leaf, and how many it has. */
  final int[] first;

  final int[] count;

  private final int[] order;
  private final double[] centres;
  private int nodes;

  MeshTree(TriangleMesh mesh) {
    int triangles = mesh.triangles();
    order = new int[triangles];
    centres = new double[3 * triangles];
    for (int i = 0; i < triangles; i++) {
      order[i] = i;
      for (int corner = 0; corner < 3; corner++) {
        for (int axis = 0; axis < 3; axis++) {
          centres[3 * i + axis] += mesh.coordinate(mesh.corner(i, corner), axis);
        }
      }
    }
    second = new int[2 * triangles];
    first = new int[2 * triangles];
    count = new int[2 * triangles];
    boxes = new double[2 * BOX * triangles];
    corners = new double[9 * triangles];
    normals = new double[NORMALS * triangles];
    owned = new boolean[3 * triangles];
    split(0, triangles);
    boolean[] seen = new boolean[mesh.points()];
    for (int i = 0; i < triangles; i++) {
      for (int corner = 0; corner < 3; corner++) {
        int point = mesh.corner(order[i], corner);
        owned[3 * i + corner] = !seen[point];
        seen[point] = true;
        for (int axis = 0; axis < 3; axis++) {
          corners[9 * i + 3 * corner + axis] = mesh.coordinate(mesh.corner(order[i], corner), axis);
        }
      }
    }
    for (int node = nodes - 1; node >= 0; node--) {
      surround(node);
    }
    face(mesh);
  }

  private int split(int from, int to) {
    int node = nodes++;
    if (to - from <= LEAF) {
      first[node] = from;
      count[node] = to - from;
      return node;
    }
    int middle = (from + to) >>> 1;
    part(from, to - 1, middle, longest(from, to));
    split(from, middle);
    second[node] = split(middle, to);
    return node;
  }

  private int longest(int from, int to) {
    int longest = 0;
    double length = -1;
    for (int axis = 0; axis < 3; axis++) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (int i = from; i < to; i++) {
        double at = centres[3 * order[i] + axis];
        least = Math.min(least, at);
        most = Math.max(most, at);
      }
      if (most - least > length) {
        length = most - least;
        longest = axis;
      }
    }
    return longest;
  }

  /** Has what is less along an axis before a place, and what is more behind (C. Hoare's find). */
  private void part(int from, int to, int place, int axis) {
    int low = from;
    int high = to;
    while (low < high) {
      double pivot = centres[3 * order[(low + high) >>> 1] + axis];
      int i = low;
      int j = high;
      while (i <= j) {
        while (centres[3 * order[i] + axis] < pivot) {
          i++;
        }
        while (centres[3 * order[j] + axis] > pivot) {
          j--;
        }
        if (i <= j) {
          int swapped = order[i];
          order[i++] = order[j];
          order[j--] = swapped;
        }
      }
      if (place <= j) {
        high = j;
      } else if (place >= i) {
        low = i;
      } else {
        return;
      }
    }
  }

  private void surround(int node) {
    int at = BOX * node;
    for (int axis = 0; axis < 3; axis++) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      if (second[node] == 0) {
        for (int i = 9 * first[node] + axis; i < 9 * (first[node] + count[node]); i += 3) {
          least = Math.min(least, corners[i]);
          most = Math.max(most, corners[i]);
        }
      } else {
        int one = BOX * (node + 1) + axis;
        int other = BOX * second[node] + axis;
        least = Math.min(boxes[one], boxes[other]);
        most = Math.max(boxes[one + 3], boxes[other + 3]);
      }
      boxes[at + axis] = least;
      boxes[at + 3 + axis] = most;
    }
  }

  /** Works out where the surface faces. */
  private void face(TriangleMesh mesh) {
    double[] points = new double[3 * mesh.points()];
    Map<Long, double[]> edges = new HashMap<>();
    for (int i = 0; i < order.length; i++) {
      double[] normal = normal(i);
      System.arraycopy(normal, 0, normals, NORMALS * i, 3);
      for (int corner = 0; corner < 3; corner++) {
        double angle = angle(i, corner);
        double[] edge = edges.computeIfAbsent(edge(mesh, i, corner), _ -> new double[3]);
        for (int axis = 0; axis < 3; axis++) {
          points[3 * mesh.corner(order[i], corner) + axis] += angle * normal[axis];
          edge[axis] += normal[axis];
        }
      }
    }
    for (int i = 0; i < order.length; i++) {
      for (int corner = 0; corner < 3; corner++) {
        System.arraycopy(
            edges.get(edge(mesh, i, corner)), 0, normals, NORMALS * i + 3 + 3 * corner, 3);
        System.arraycopy(
            points, 3 * mesh.corner(order[i], corner), normals, NORMALS * i + 12 + 3 * corner, 3);
      }
    }
  }

  /** The edge from a corner to the next one. */
  private long edge(TriangleMesh mesh, int triangle, int corner) {
    int from = mesh.corner(order[triangle], corner);
    int to = mesh.corner(order[triangle], (corner + 1) % 3);
    return ((long) Math.min(from, to) << 32) | Math.max(from, to);
  }

  /** The direction out of a triangle; 0 for one that is too thin to have any. */
  private double[] normal(int triangle) {
    double[] one = side(triangle, 0, 1);
    double[] other = side(triangle, 0, 2);
    double[] last = side(triangle, 1, 2);
    double[] normal = {
      one[1] * other[2] - one[2] * other[1],
      one[2] * other[0] - one[0] * other[2],
      one[0] * other[1] - one[1] * other[0]
    };
    double length = length(normal);
    double longest = Math.max(length(one), Math.max(length(other), length(last)));
    boolean thin = length <= THIN * longest * longest;
    for (int axis = 0; axis < 3; axis++) {
      normal[axis] = thin ? 0 : normal[axis] / length;
    }
    return normal;
  }

  private double angle(int triangle, int corner) {
    double[] one = side(triangle, corner, (corner + 1) % 3);
    double[] other = side(triangle, corner, (corner + 2) % 3);
    double dot = one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    double cosine = dot / (length(one) * length(other));
    return Math.acos(Math.max(-1, Math.min(1, cosine)));
  }

  private double[] side(int triangle, int from, int to) {
    double[] side = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      side[axis] = corners[9 * triangle + 3 * to + axis] - corners[9 * triangle + 3 * from + axis];
    }
    return side;
  }

  private static double length(double[] v) {
    return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
}
