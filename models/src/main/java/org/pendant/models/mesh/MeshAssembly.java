package org.pendant.models.mesh;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import org.pendant.models.json.JsonValues;

/**
 * Mesh assembly: makes a solid of the triangles of a file, and refuses what is none. Points at the
 * same place are one.
 */
final class MeshAssembly {
  /** Coordinates beyond this are no lengths of anything, m. */
  private static final double MAX_COORDINATE_M = 100;

  private final double scale;
  private final Map<Place, Integer> numbers = new HashMap<>();
  private double[] points = new double[3 * 64];
  private int[] corners = new int[3 * 128];
  private int cornerCount;
  private int read;

  private record Place(double x, double y, double z) {}

  MeshAssembly(MeshUnit unit) {
    scale = unit.lengthM();
  }

  /**
   * The number of a point.
   *
   * @param where it is in the file, for messages
   */
  int point(String where, double x, double y, double z) throws MeshException {
    for (double each : new double[] {x, y, z}) {
      if (!Double.isFinite(each)) {
        throw new MeshException(where + ": a coordinate is " + each + ", must be a number");
      }
      if (Math.abs(each * scale) > MAX_COORDINATE_M) {
        throw new MeshException(
            String.format(
                Locale.ROOT,
                "%s: a coordinate is %s, which is %.3g m; must be at most %.0f m: is the unit"
                    + " right?",
                where,
                each,
                each * scale,
                MAX_COORDINATE_M));
      }
    }
    // adding 0 makes one zero of both
    Place place = new Place(x * scale + 0.0, y * scale + 0.0, z * scale + 0.0);
    Integer known = numbers.get(place);
    if (known != null) {
      return known;
    }
    int number = numbers.size();
    if (number == 3 * TriangleMesh.MAX_TRIANGLES) {
      throw new MeshException(
          where + ": more points than " + number + ", must be at most that many");
    }
    if (3 * number == points.length) {
      points = Arrays.copyOf(points, 2 * points.length);
    }
    points[3 * number] = place.x();
    points[3 * number + 1] = place.y();
    points[3 * number + 2] = place.z();
    numbers.put(place, number);
    return number;
  }

  /** Adds a triangle; one with two corners at the same place is nothing, and left out. */
  void triangle(int a, int b, int c) throws MeshException {
    if (++read > TriangleMesh.MAX_TRIANGLES) {
      throw new MeshException(tooMany("more than " + TriangleMesh.MAX_TRIANGLES));
    }
    if (a == b || b == c || c == a) {
      return;
    }
    if (cornerCount == corners.length) {
      corners = Arrays.copyOf(corners, 2 * corners.length);
    }
    corners[cornerCount++] = a;
    corners[cornerCount++] = b;
    corners[cornerCount++] = c;
  }

  static String tooMany(String count) {
    return "has "
        + count
        + " triangles, must be at most "
        + TriangleMesh.MAX_TRIANGLES
        + ": export it coarser";
  }

  /** The solid. */
  TriangleMesh mesh() throws MeshException {
    if (read == 0) {
      throw new MeshException("has no triangles, must have at least 4");
    }
    if (cornerCount == 0) {
      throw new MeshException("no triangle has an area");
    }
    corners = Arrays.copyOf(corners, cornerCount);
    keepUsed();
    requireSize();
    requireClosed();
    double volume = TriangleMesh.volume(points, corners);
    if (volume < 0) {
      turn();
    }
    TriangleMesh mesh = new TriangleMesh(points, corners);
    double longest = longest();
    if (mesh.volumeM3() < 1e-9 * longest * longest * longest) {
      throw new MeshException("fills no space, must be the surface of a solid");
    }
    return mesh;
  }

  /** Keeps the points that triangles have, in the order in which they have them. */
  private void keepUsed() {
    int[] kept = new int[numbers.size()];
    double[] used = new double[3 * Math.min(kept.length, corners.length)];
    int count = 0;
    for (int i = 0; i < corners.length; i++) {
      int point = corners[i];
      if (kept[point] == 0) {
        System.arraycopy(points, 3 * point, used, 3 * count, 3);
        kept[point] = ++count;
      }
      corners[i] = kept[point] - 1;
    }
    points = Arrays.copyOf(used, 3 * count);
  }

  private double longest() {
    double longest = 0;
    for (int axis = 0; axis < 3; axis++) {
      double least = Double.POSITIVE_INFINITY;
      double most = Double.NEGATIVE_INFINITY;
      for (int i = axis; i < points.length; i += 3) {
        least = Math.min(least, points[i]);
        most = Math.max(most, points[i]);
      }
      longest = Math.max(longest, most - least);
    }
    return longest;
  }

  private void requireSize() throws MeshException {
    double longest = longest();
    if (longest > TriangleMesh.MAX_LENGTH_M || longest < TriangleMesh.MIN_LENGTH_M) {
      throw new MeshException(
          String.format(
              Locale.ROOT, "is %.3g m long, must be 0.001 to 10 m: is the unit right?", longest));
    }
  }

  /** For each edge, how many triangles go along it in one direction more than in the other. */
  private void requireClosed() throws MeshException {
    Map<Long, Integer> more = new HashMap<>();
    for (int i = 0; i < cornerCount; i++) {
      int from = corners[i];
      int to = corners[i % 3 == 2 ? i - 2 : i + 1];
      long edge = ((long) Math.min(from, to) << 32) | Math.max(from, to);
      more.merge(edge, from < to ? 1 : -1, Integer::sum);
    }
    long open = more.values().stream().filter(each -> each != 0).count();
    if (open == 0) {
      return;
    }
    for (int i = 0; i < cornerCount; i++) {
      int from = corners[i];
      int to = corners[i % 3 == 2 ? i - 2 : i + 1];
      if (more.get(((long) Math.min(from, to) << 32) | Math.max(from, to)) != 0) {
        throw new MeshException(
            "is not closed: "
                + open
                + (open == 1 ? " edge has" : " edges have")
                + " no triangle on the other side, or one that faces the other way, the first from "
                + place(from)
                + " to "
                + place(to)
                + "; must be the surface of a solid");
      }
    }
  }

  /** Where a point is, as the file has it. */
  private String place(int point) {
    return "("
        + inFile(3 * point)
        + ", "
        + inFile(3 * point + 1)
        + ", "
        + inFile(3 * point + 2)
        + ")";
  }

  private String inFile(int index) {
    return JsonValues.number(Math.rint(points[index] / scale * 1e4) / 1e4);
  }

  /** Has all triangles face the other way. */
  private void turn() {
    for (int i = 0; i < cornerCount; i += 3) {
      int second = corners[i + 1];
      corners[i + 1] = corners[i + 2];
      corners[i + 2] = second;
    }
  }
}
