package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Hull triangles: the convex hull of points, as triangles. C. B. Barber, D. P. Dobkin, H.
 * Huhdanpaa: "The Quickhull Algorithm for Convex Hulls" (1996), but always with the point that is
 * farthest out of all, so that one may stop early with a hull that misses little.
 *
 * <p>Points are rounded to a grid of {@value #GRID} steps along the longest side, and which side of
 * a plane they are on is reckoned in whole numbers, without any error. So flat faces, points on one
 * line and points at one place need no tolerances, and nothing can go wrong with any input.
 */
final class HullTriangles {
  /** Steps of the grid: a determinant of three differences stays below 2^63. */
  private static final int GRID = 1 << 20;

  /** What sticks out by less than this many steps is not worth a corner. */
  private static final double SKIPPED = 2;

  private final long[] grid;
  private final int most;
  private final List<Face> faces = new ArrayList<>();
  private final int[] nextOutside;
  private final List<Integer> chosen = new ArrayList<>();

  /** A triangle, counter-clockwise as seen from outside. */
  private final class Face {
    final int[] corners;
    final Face[] beyond = new Face[3];
    final long x;
    final long y;
    final long z;
    final double length;
    int outside = -1;
    int farthest = -1;
    double farthestAway = SKIPPED;
    boolean gone;

    Face(int a, int b, int c) {
      corners = new int[] {a, b, c};
      long ux = grid[3 * b] - grid[3 * a];
      long uy = grid[3 * b + 1] - grid[3 * a + 1];
      long uz = grid[3 * b + 2] - grid[3 * a + 2];
      long vx = grid[3 * c] - grid[3 * a];
      long vy = grid[3 * c + 1] - grid[3 * a + 1];
      long vz = grid[3 * c + 2] - grid[3 * a + 2];
      x = uy * vz - uz * vy;
      y = uz * vx - ux * vz;
      z = ux * vy - uy * vx;
      length = Math.sqrt((double) x * x + (double) y * y + (double) z * z);
    }

    /** Above 0 where a point is outside of it. */
    long height(int point) {
      int a = corners[0];
      return x * (grid[3 * point] - grid[3 * a])
          + y * (grid[3 * point + 1] - grid[3 * a + 1])
          + z * (grid[3 * point + 2] - grid[3 * a + 2]);
    }

    /** How far a point is outside, in steps of the grid. */
    double away(int point) {
      return height(point) / length;
    }

    void keep(int point, double away) {
      nextOutside[point] = outside;
      outside = point;
      if (away > farthestAway) {
        farthestAway = away;
        farthest = point;
      }
    }
  }

  /**
   * The hull of points.
   *
   * @param points three coordinates each
   * @param most corners that it takes up at most, at least 4
   * @throws MeshException if all are in one plane
   */
  HullTriangles(double[] points, int most) throws MeshException {
    this.most = most;
    grid = onGrid(points);
    nextOutside = new int[points.length / 3];
    begin();
    for (Face face = farthestOut(); face != null; face = farthestOut()) {
      grow(face);
    }
  }

  /** Three numbers of points for each triangle. */
  int[] corners() {
    return faces.stream().flatMapToInt(each -> Arrays.stream(each.corners)).toArray();
  }

  private static long[] onGrid(double[] points) {
    double[] least = new double[3];
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
      double most = Double.NEGATIVE_INFINITY;
      least[axis] = Double.POSITIVE_INFINITY;
      for (int i = axis; i < points.length; i += 3) {
        least[axis] = Math.min(least[axis], points[i]);
        most = Math.max(most, points[i]);
      }
      longest = Math.max(longest, most - least[axis]);
    }
    long[] grid = new long[points.length];
    for (int i = 0; i < grid.length; i++) {
      grid[i] = Math.round((points[i] - least[i % 3]) / longest * GRID);
    }
    return grid;
  }

  /** Four points that are far from each other. */
  private void begin() throws MeshException {
    int[] extreme = new int[2];
    long widest = -1;
    for (int axis = 0; axis < 3; axis++) {
      int low = 0;
      int high = 0;
      for (int i = 1; i < nextOutside.length; i++) {
        low = grid[3 * i + axis] < grid[3 * low + axis] ? i : low;
        high = grid[3 * i + axis] > grid[3 * high + axis] ? i : high;
      }
      if (grid[3 * high + axis] - grid[3 * low + axis] > widest) {
        widest = grid[3 * high + axis] - grid[3 * low + axis];
        extreme[0] = low;
        extreme[1] = high;
      }
    }
    int third = -1;
    double area = 0;
    for (int i = 0; i < nextOutside.length; i++) {
      double size = new Face(extreme[0], extreme[1], i).length;
      if (size > area) {
        area = size;
        third = i;
      }
    }
    int fourth = -1;
    long volume = 0;
    Face base = third < 0 ? null : new Face(extreme[0], extreme[1], third);
    for (int i = 0; base != null && i < nextOutside.length; i++) {
      if (Math.abs(base.height(i)) > Math.abs(volume)) {
        volume = base.height(i);
        fourth = i;
      }
    }
    if (fourth < 0 || Math.abs(volume) / base.length < SKIPPED) {
      throw new MeshException(text("flat"));
    }
    int a = extreme[0];
    int b = volume < 0 ? extreme[1] : third;
    int c = volume < 0 ? third : extreme[1];
    faces.add(new Face(a, b, c));
    faces.add(new Face(a, c, fourth));
    faces.add(new Face(c, b, fourth));
    faces.add(new Face(b, a, fourth));
    chosen.addAll(List.of(a, b, c, fourth));
    join(faces);
    for (int i = 0; i < nextOutside.length; i++) {
      give(i, faces);
    }
  }

  /** Tells triangles that have all their neighbours among them about each other. */
  private static void join(List<Face> closed) {
    Map<Long, Face> byEdge = new HashMap<>();
    for (Face face : closed) {
      for (int i = 0; i < 3; i++) {
        byEdge.put(edge(face.corners[i], face.corners[(i + 1) % 3]), face);
      }
    }
    for (Face face : closed) {
      for (int i = 0; i < 3; i++) {
        face.beyond[i] = byEdge.get(edge(face.corners[(i + 1) % 3], face.corners[i]));
      }
    }
  }

  private static long edge(int from, int to) {
    return ((long) from << 32) | to;
  }

  /** Gives a point to the face that it is farthest out of, among those that are new. */
  private void give(int point, List<Face> made) {
    Face best = farthestFrom(point, made);
    if (best != null && best.away(point) <= SKIPPED) {
      // hardly outside of these, but perhaps of others
      best = farthestFrom(point, faces);
    }
    if (best != null) {
      best.keep(point, best.away(point));
    }
  }

  private static Face farthestFrom(int point, List<Face> among) {
    Face best = null;
    double most = 0;
    for (Face face : among) {
      double away = face.away(point);
      if (away > most) {
        most = away;
        best = face;
      }
    }
    return best;
  }

  /** The face with the point that is farthest out; null where the hull is done. */
  private Face farthestOut() {
    Face best = null;
    for (Face face : faces) {
      if (face.farthest >= 0 && (best == null || face.farthestAway > best.farthestAway)) {
        best = face;
      }
    }
    return chosen.size() < most ? best : null;
  }

  /** Takes a point up: what it sees goes, and new triangles lead from it to what is around that. */
  private void grow(Face from) {
    int point = from.farthest;
    chosen.add(point);
    List<Face> seen = new ArrayList<>(List.of(from));
    from.gone = true;
    Deque<Face> open = new ArrayDeque<>(seen);
    List<Face> made = new ArrayList<>();
    Map<Integer, Face> byFirst = new HashMap<>();
    while (!open.isEmpty()) {
      Face face = open.remove();
      for (int i = 0; i < 3; i++) {
        Face beyond = face.beyond[i];
        if (!beyond.gone && beyond.height(point) > 0) {
          beyond.gone = true;
          seen.add(beyond);
          open.add(beyond);
        }
      }
    }
    for (Face face : seen) {
      for (int i = 0; i < 3; i++) {
        Face beyond = face.beyond[i];
        if (!beyond.gone) {
          int first = face.corners[i];
          int second = face.corners[(i + 1) % 3];
          Face next = new Face(first, second, point);
          next.beyond[0] = beyond;
          for (int k = 0; k < 3; k++) {
            if (beyond.corners[k] == second) {
              beyond.beyond[k] = next;
            }
          }
          made.add(next);
          byFirst.put(first, next);
        }
      }
    }
    for (Face face : made) {
      Face after = byFirst.get(face.corners[1]);
      face.beyond[1] = after;
      after.beyond[2] = face;
    }
    faces.removeIf(each -> each.gone);
    faces.addAll(made);
    for (Face face : seen) {
      int next;
      for (int i = face.outside; i >= 0; i = next) {
        next = nextOutside[i];
        give(i, made);
      }
    }
  }
}
