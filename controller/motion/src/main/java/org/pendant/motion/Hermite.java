package org.pendant.motion;

/**
 * Hermite polynomial for each of several coordinates that joins two points with given speeds. The
 * cubic one is the parabola of even acceleration where the speeds allow that; the smooth one begins
 * and ends without acceleration.
 */
final class Hermite {
  private static final int MAX_TERMS = 6;

  private final double durationS;
  private final int coordinates;
  private final double[][] terms;

  private Hermite(double durationS, int coordinates) {
    this.durationS = durationS;
    this.coordinates = coordinates;
    terms = new double[coordinates][MAX_TERMS];
  }

  /**
   * A polynomial.
   *
   * @param smooth whether it begins and ends without acceleration
   */
  static Hermite of(
      double[] from,
      double[] fromSpeed,
      double[] to,
      double[] toSpeed,
      double lastsS,
      boolean smooth) {
    Hermite made = new Hermite(lastsS, from.length);
    for (int i = 0; i < from.length; i++) {
      double step = to[i] - from[i];
      double v0 = fromSpeed[i] * lastsS;
      double v1 = toSpeed[i] * lastsS;
      double[] c = made.terms[i];
      c[0] = from[i];
      c[1] = v0;
      if (smooth) {
        c[3] = 10 * step - 6 * v0 - 4 * v1;
        c[4] = -15 * step + 8 * v0 + 7 * v1;
        c[5] = 6 * step - 3 * v0 - 3 * v1;
      } else {
        c[2] = 3 * step - 2 * v0 - v1;
        c[3] = -2 * step + v0 + v1;
      }
    }
    return made;
  }

  double durationS() {
    return durationS;
  }

  /** Position, speed and acceleration of every coordinate at a time. */
  void at(double timeS, double[] position, double[] speed, double[] acceleration) {
    double u = Math.max(0, Math.min(1, timeS / durationS));
    for (int i = 0; i < coordinates; i++) {
      double[] c = terms[i];
      position[i] = c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))));
      speed[i] =
          (c[1] + u * (2 * c[2] + u * (3 * c[3] + u * (4 * c[4] + u * 5 * c[5])))) / durationS;
      acceleration[i] =
          (2 * c[2] + u * (6 * c[3] + u * (12 * c[4] + u * 20 * c[5]))) / durationS / durationS;
    }
  }
}
