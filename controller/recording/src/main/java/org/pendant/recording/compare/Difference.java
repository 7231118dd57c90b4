package org.pendant.recording.compare;

import java.util.Locale;

/** Difference: what a recording and Pendant's run differ in, by a name that limits use. */
public sealed interface Difference {
  /** Its name, such as {@code duration} or {@code target_moment_2}. */
  String name();

  /** The symbol of its unit; empty where there is none. */
  String unit();

  /** What a limit is compared with, at least 0. */
  double size();

  /**
   * A number that each of the runs has once.
   *
   * @param recorded that of the recording
   * @param pendant that of Pendant
   * @param error by how much Pendant is off; between two samples nothing is known better
   */
  record Figure(String name, String unit, double recorded, double pendant, double error)
      implements Difference {
    @Override
    public double size() {
      return Math.abs(error);
    }
  }

  /**
   * A number that goes with time, compared at all samples of the recording.
   *
   * @param least of the recording
   * @param most of the recording
   * @param mean of Pendant less recording
   * @param rms the same, root of the mean square
   * @param largest the same, the largest either way
   */
  record Residual(
      String name, String unit, double least, double most, double mean, double rms, double largest)
      implements Difference {
    @Override
    public double size() {
      return rms;
    }
  }

  /** A number as tables show it: four digits that tell something. */
  static String text(double value) {
    if (Double.isNaN(value)) {
      return "-";
    }
    double size = Math.abs(value);
    if (size != 0 && (size < 1e-4 || size >= 1e5)) {
      return String.format(Locale.ROOT, "%.2e", value);
    }
    int digits = size >= 1000 ? 1 : size >= 100 ? 2 : size >= 1 ? 3 : 4;
    String text = String.format(Locale.ROOT, "%." + digits + "f", value);
    return text.matches("-0\\.?0*") ? text.substring(1) : text;
  }
}
