package org.pendant.models.mesh;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Hull faces: makes polygons of those triangles of a hull that are nearly in one plane. */
final class HullFaces {
  /** What is so near to a plane is in it, of the longest side. */
  private static final double FLAT = 2e-5;

  /** Triangles of one face do not face otherwise by more than this, as a cosine. */
  private static final double SAME_WAY = 0.99;

  private final double[] all;
  private final int[] triangles;
  private final double[] normals;
  private final double[] areas;
  private final double[] heights;
  private final double flatM;
  private final Map<Long, Integer> byEdge = new HashMap<>();
  private final int[] group;
  private final List<int[]> faces = new ArrayList<>();
  private final double[] points;
  private final int[][] edges;

  /**
   * The faces of a hull.
   *
   * @param all points, of which the hull has some
   * @param triangles three numbers of points each
   */
  HullFaces(double[] all, int[] triangles) {
    this.all = all;
    this.triangles = triangles;
    int count = triangles.length / 3;
    normals = new double[triangles.length];
    areas = new double[count];
    heights = new double[count];
    group = new int[count];
    Arrays.fill(group, -1);
    for (int i = 0; i < count; i++) {
      measure(i);
      for (int k = 0; k < 3; k++) {
        byEdge.put(edge(triangles[3 * i + k], triangles[3 * i + (k + 1) % 3]), i);
      }
    }
    flatM = FLAT * longest();
    IntStream.range(0, count)
        .boxed()
        .sorted(Comparator.comparingDouble((Integer i) -> -areas[i]))
        .filter(i -> group[i] < 0)
        .forEach(this::addFace);
    points = renumber();
    edges = edges(faces);
  }

  double[] points() {
    return points;
  }

  int[][] faces() {
    return faces.toArray(int[][]::new);
  }

  int[][] edges() {
    return edges;
  }

  private static long edge(int from, int to) {
    return ((long) from << 32) | to;
  }

  private void measure(int triangle) {
    int a = 3 * triangles[3 * triangle];
    int b = 3 * triangles[3 * triangle + 1];
    int c = 3 * triangles[3 * triangle + 2];
    double[] n = new double[3];
    for (int axis = 0; axis < 3; axis++) {
      int y = (axis + 1) % 3;
      int z = (axis + 2) % 3;
      n[axis] =
          (all[b + y] - all[a + y]) * (all[c + z] - all[a + z])
              - (all[b + z] - all[a + z]) * (all[c + y] - all[a + y]);
    }
    double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    areas[triangle] = length / 2;
    heights[triangle] = length / Math.max(away(a, b), Math.max(away(b, c), away(c, a)));
    for (int axis = 0; axis < 3; axis++) {
      normals[3 * triangle + axis] = length > 0 ? n[axis] / length : 0;
    }
  }

  private double away(int from, int to) {
    double x = all[to] - all[from];
    double y = all[to + 1] - all[from + 1];
    double z = all[to + 2] - all[from + 2];
    return Math.sqrt(x * x + y * y + z * z);
  }

  private double longest() {
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (int corner : triangles) {
        least = Math.min(least, all[3 * corner + axis]);
        most = Math.max(most, all[3 * corner + axis]);
      }
      longest = Math.max(longest, most - least);
    }
    return longest;
  }

  private void addFace(int seed) {
    List<Integer> members = new ArrayList<>(List.of(seed));
    Deque<Integer> open = new ArrayDeque<>(members);
    int number = faces.size();
    group[seed] = number;
    while (!open.isEmpty()) {
      int triangle = open.remove();
      for (int k = 0; k < 3; k++) {
        int beyond = beyond(triangle, k);
        if (group[beyond] < 0 && inPlane(beyond, seed)) {
          group[beyond] = number;
          members.add(beyond);
          open.add(beyond);
        }
      }
    }
    int[] loop = around(members, number);
    if (loop.length == 0) {
      // a ring, or pinched: the seed alone, the others come later
      members.forEach(each -> group[each] = -1);
      group[seed] = number;
      loop = new int[] {triangles[3 * seed], triangles[3 * seed + 1], triangles[3 * seed + 2]};
    }
    faces.add(loop);
  }

  private int beyond(int triangle, int side) {
    return byEdge.get(
        edge(triangles[3 * triangle + (side + 1) % 3], triangles[3 * triangle + side]));
  }

  private boolean inPlane(int triangle, int seed) {
    int at = 3 * triangles[3 * seed];
    double nx = normals[3 * seed];
    double ny = normals[3 * seed + 1];
    double nz = normals[3 * seed + 2];
    for (int k = 0; k < 3; k++) {
      int p = 3 * triangles[3 * triangle + k];
      double height =
          nx * (all[p] - all[at])
              + ny * (all[p + 1] - all[at + 1])
              + nz * (all[p + 2] - all[at + 2]);
      if (Math.abs(height) > flatM) {
        return false;
      }
    }
    double same =
        nx * normals[3 * triangle]
            + ny * normals[3 * triangle + 1]
            + nz * normals[3 * triangle + 2];
    // a sliver has no direction worth asking
    return same > SAME_WAY || heights[triangle] < 4 * flatM;
  }

  /** The points around some triangles; empty where these are not around one piece. */
  private int[] around(List<Integer> members, int number) {
    Map<Integer, Integer> next = new LinkedHashMap<>();
    int borders = 0;
    for (int triangle : members) {
      for (int k = 0; k < 3; k++) {
        if (group[beyond(triangle, k)] != number) {
          borders++;
          next.put(triangles[3 * triangle + k], triangles[3 * triangle + (k + 1) % 3]);
        }
      }
    }
    if (next.size() != borders || borders < 3) {
      return new int[0];
    }
    int[] loop = new int[borders];
    int at = next.keySet().iterator().next();
    for (int i = 0; i < borders; i++) {
      loop[i] = at;
      at = next.get(at);
    }
    return at == loop[0] && Arrays.stream(loop).distinct().count() == borders ? loop : new int[0];
  }

  /** Keeps the points that faces have. */
  private double[] renumber() {
    Map<Integer, Integer> numbers = new LinkedHashMap<>();
    for (int[] face : faces) {
      for (int i = 0; i < face.length; i++) {
        int count = numbers.size();
        face[i] = numbers.computeIfAbsent(face[i], _ -> count);
      }
    }
    double[] kept = new double[3 * numbers.size()];
    numbers.forEach((old, now) -> System.arraycopy(all, 3 * old, kept, 3 * now, 3));
    return kept;
  }

  /** The edges between faces: two corners and the faces on both sides. */
  static int[][] edges(List<int[]> faces) {
    Map<Long, int[]> found = new LinkedHashMap<>();
    for (int f = 0; f < faces.size(); f++) {
      int[] face = faces.get(f);
      for (int i = 0; i < face.length; i++) {
        int from = face[i];
        int to = face[(i + 1) % face.length];
        int[] other = found.get(edge(to, from));
        if (other == null) {
          found.put(edge(from, to), new int[] {from, to, f, f});
        } else {
          other[3] = f;
        }
      }
    }
    return found.values().toArray(int[][]::new);
  }
}
