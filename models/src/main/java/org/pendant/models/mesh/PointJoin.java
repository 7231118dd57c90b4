package org.pendant.models.mesh;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Point join: finds points that are meant to be one. Programs that write each triangle by itself
 * round its corners, or reckon them twice.
 */
final class PointJoin {
  private final double[] points;
  private final double withinM;
  private final Map<Cell, List<Integer>> byCell = new HashMap<>();

  private record Cell(long x, long y, long z) {}

  private PointJoin(double[] points, double withinM) {
    this.points = points;
    this.withinM = withinM;
  }

  /**
   * For each point the first one that is as near as that, which may be itself.
   *
   * @param points three coordinates each
   */
  static int[] firstWithin(double[] points, double withinM) {
    return new PointJoin(points, withinM).join();
  }

  private int[] join() {
    int[] first = new int[points.length / 3];
    for (int i = 0; i < first.length; i++) {
      Cell cell = new Cell(along(i, 0), along(i, 1), along(i, 2));
      first[i] = near(i, cell);
      if (first[i] == i) {
        byCell.computeIfAbsent(cell, _ -> new ArrayList<>()).add(i);
      }
    }
    return first;
  }

  private long along(int point, int axis) {
    return (long) Math.floor(points[3 * point + axis] / withinM);
  }

  private int near(int point, Cell cell) {
    int first = point;
    for (int n = 0; n < 27; n++) {
      Cell around = new Cell(cell.x + n % 3 - 1, cell.y + n / 3 % 3 - 1, cell.z + n / 9 - 1);
      for (int other : byCell.getOrDefault(around, List.of())) {
        if (other < first && square(point, other) <= withinM * withinM) {
          first = other;
        }
      }
    }
    return first;
  }

  private double square(int one, int other) {
    double x = points[3 * one] - points[3 * other];
    double y = points[3 * one + 1] - points[3 * other + 1];
    double z = points[3 * one + 2] - points[3 * other + 2];
    return x * x + y * y + z * z;
  }
}
