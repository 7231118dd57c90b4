package org.pendant.motion.toolpath;

/**
 * Spline: the smoothest curve through values at even distances that begins and ends level: cubic
 * pieces whose first and second derivatives agree. (C. de Boor, "A Practical Guide to Splines",
 * Springer 2001, chapter IV.)
 */
final class Spline {
  private final double[] values;
  private final double[] bends;
  private final double step;

  /**
   * A curve.
   *
   * @param values at 0, {@code step}, 2 {@code step} and so on; two at least
   */
  Spline(double[] values, double step) {
    this.values = values.clone();
    this.step = step;
    bends = bends(values, step);
  }

  /** Solves the tridiagonal system of the second derivatives (Thomas). */
  private static double[] bends(double[] y, double h) {
    int n = y.length;
    double[] upper = new double[n];
    double[] bend = new double[n];
    double f = 6 / (h * h);
    double diagonal = 2;
    bend[0] = f * (y[1] - y[0]) / diagonal;
    upper[0] = 1 / diagonal;
    for (int i = 1; i < n; i++) {
      boolean last = i == n - 1;
      double right = last ? f * (y[i - 1] - y[i]) : f * (y[i + 1] - 2 * y[i] + y[i - 1]);
      double pivot = (last ? 2 : 4) - upper[i - 1];
      upper[i] = 1 / pivot;
      bend[i] = (right - bend[i - 1]) / pivot;
    }
    for (int i = n - 2; i >= 0; i--) {
      bend[i] -= upper[i] * bend[i + 1];
    }
    return bend;
  }

  private int piece(double at) {
    return (int) Math.max(0, Math.min(values.length - 2, Math.floor(at / step)));
  }

  double value(double at) {
    int i = piece(at);
    double b = at / step - i;
    double a = 1 - b;
    double h = step * step / 6;
    return a * values[i]
        + b * values[i + 1]
        + h * ((a * a * a - a) * bends[i] + (b * b * b - b) * bends[i + 1]);
  }

  double slope(double at) {
    int i = piece(at);
    double b = at / step - i;
    double a = 1 - b;
    return (values[i + 1] - values[i]) / step
        + step / 6 * ((1 - 3 * a * a) * bends[i] + (3 * b * b - 1) * bends[i + 1]);
  }

  double bend(double at) {
    int i = piece(at);
    double b = at / step - i;
    return (1 - b) * bends[i] + b * bends[i + 1];
  }
}
