package org.pendant.motion;

/**
 * Circular arc in space, or a straight piece where the circle is too large to tell. It is given by
 * where it begins, in which direction, and how it bends, so that nearly straight ones are exact.
 */
final class Arc {
  /** Sine of the angle between tangent and chord below which a piece counts as straight. */
  private static final double STRAIGHT = 1e-9;

  private final double[] from;
  private final double[] tangent;

  /** From the start towards the centre, of length 1; zero for a straight piece. */
  private final double[] inwards = new double[3];

  private final double radius;
  private final double length;

  private Arc(double[] from, double[] tangent, double[] inwards, double radius, double length) {
    this.from = from;
    this.tangent = tangent;
    System.arraycopy(inwards, 0, this.inwards, 0, 3);
    this.radius = radius;
    this.length = length;
  }

  /**
   * The arc that leaves a point in a direction and comes to another one.
   *
   * @param tangent of length 1
   */
  static Arc leaving(double[] from, double[] tangent, double[] to) {
    double[] chord = minus(to, from);
    double along = dot(chord, tangent);
    double[] aside = new double[3];
    for (int i = 0; i < 3; i++) {
      aside[i] = chord[i] - along * tangent[i];
    }
    double beside = size(aside);
    double distance = size(chord);
    if (beside <= STRAIGHT * distance) {
      return new Arc(from, tangent, new double[3], Double.POSITIVE_INFINITY, along);
    }
    double radius = distance * distance / (2 * beside);
    for (int i = 0; i < 3; i++) {
      aside[i] /= beside;
    }
    return new Arc(from, tangent, aside, radius, 2 * radius * Math.atan2(beside, along));
  }

  /** The length, m. */
  double length() {
    return length;
  }

  /** The radius, m; infinite for a straight piece. */
  double radius() {
    return radius;
  }

  /** A point, {@code at} metres from the start; written to {@code place} from {@code offset} on. */
  void place(double at, double[] place, int offset) {
    double turn = at / radius;
    double half = Math.sin(0.5 * turn);
    double forth = turn == 0 ? at : radius * Math.sin(turn);
    double aside = turn == 0 ? 0 : 2 * radius * half * half;
    for (int i = 0; i < 3; i++) {
      place[offset + i] = from[i] + forth * tangent[i] + aside * inwards[i];
    }
  }

  /** The direction there, of length 1, written to the first three numbers. */
  void direction(double at, double[] direction) {
    double turn = at / radius;
    double cos = Math.cos(turn);
    double sin = Math.sin(turn);
    for (int i = 0; i < 3; i++) {
      direction[i] = cos * tangent[i] + sin * inwards[i];
    }
  }

  /** How the direction changes per metre, written to the first three numbers. */
  void bend(double at, double[] bend) {
    double turn = at / radius;
    double cos = Math.cos(turn) / radius;
    double sin = Math.sin(turn) / radius;
    for (int i = 0; i < 3; i++) {
      bend[i] = cos * inwards[i] - sin * tangent[i];
    }
  }

  static double[] minus(double[] a, double[] b) {
    return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  static double size(double[] a) {
    return Math.sqrt(dot(a, a));
  }

  static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }
}
