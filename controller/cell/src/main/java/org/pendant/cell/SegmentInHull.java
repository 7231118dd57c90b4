package org.pendant.cell;

/**
 * Segment in hull: the place of a line that is nearest to a hull, or deepest in it. How far places
 * are away from a solid without dents is a function without dents, so halving finds the least.
 */
final class SegmentInHull {
  /** What a step of the search leaves of the part where the place may be. */
  private static final double GOLDEN = (Math.sqrt(5) - 1) / 2;

  private static final int ROUNDS = 18;

  private final double[] from = new double[3];
  private final double[] along = new double[3];
  private final double[] unused = new double[3];

  /** A line along the z of a pose, around its origin. */
  void set(double[] pose12, double length) {
    for (int k = 0; k < 3; k++) {
      along[k] = length * pose12[3 * k + 2];
      from[k] = pose12[9 + k] - along[k] / 2;
    }
  }

  /** A line between two places. */
  void set(double[] from3, double[] to3) {
    for (int k = 0; k < 3; k++) {
      from[k] = from3[k];
      along[k] = to3[k] - from3[k];
    }
  }

  /** One of its ends, -1 or 1. */
  void end(int which, double[] place3) {
    at(which < 0 ? 0 : 1, place3);
  }

  /** Finds the nearest place; answers how far it is away, m, below 0 inside. */
  double nearest(Polyhedron solid, double[] place3) {
    double low = 0;
    double high = 1;
    double left = 1 - GOLDEN;
    double right = GOLDEN;
    double atLeft = away(solid, left, place3);
    double atRight = away(solid, right, place3);
    for (int round = 0; round < ROUNDS; round++) {
      if (atLeft <= atRight) {
        high = right;
        right = left;
        atRight = atLeft;
        left = high - GOLDEN * (high - low);
        atLeft = away(solid, left, place3);
      } else {
        low = left;
        left = right;
        atLeft = atRight;
        right = low + GOLDEN * (high - low);
        atRight = away(solid, right, place3);
      }
    }
    double between = away(solid, (low + high) / 2, place3);
    double first = away(solid, 0, place3);
    double last = away(solid, 1, place3);
    double least = Math.min(between, Math.min(first, last));
    at(least == between ? (low + high) / 2 : least == first ? 0 : 1, place3);
    return least;
  }

  private double away(Polyhedron solid, double share, double[] place3) {
    at(share, place3);
    return solid.away(place3[0], place3[1], place3[2], unused);
  }

  private void at(double share, double[] place3) {
    for (int k = 0; k < 3; k++) {
      place3[k] = from[k] + share * along[k];
    }
  }
}
