package org.pendant.models.kinematics;

/**
 * Sine and cosine of an angle together, by the addition theorems: those of the nearest sixteenth of
 * a radian come from a table, those of the rest, at most a thirty-second, from a short series. Each
 * is within 2.5e-16 of the true one. A frame of a moving arm takes some forty of them, which by
 * {@link Math} are a tenth of its time.
 */
final class SinCos {
  private static final int STEPS_PER_RAD = 16;
  private static final double STEP_RAD = 1.0 / STEPS_PER_RAD;

  /** As far as the table goes, rad: farther than joints with limits turn. */
  private static final int MAX_TABLE_RAD = 7;

  /** Where the angle 0 is in the table. */
  private static final int MIDDLE = MAX_TABLE_RAD * STEPS_PER_RAD;

  private static final double[] SIN = new double[2 * MIDDLE + 1];
  private static final double[] COS = new double[2 * MIDDLE + 1];

  static {
    for (int i = 0; i < SIN.length; i++) {
      SIN[i] = Math.sin((i - MIDDLE) * STEP_RAD);
      COS[i] = Math.cos((i - MIDDLE) * STEP_RAD);
    }
  }

  private SinCos() {}

  /**
   * Writes sine and cosine of an angle, rad, at a place of arrays. Beyond the table, and of numbers
   * that are not finite, they are those of {@link Math}.
   */
  static void of(double angle, int place, double[] sin, double[] cos) {
    if (!(Math.abs(angle) < MAX_TABLE_RAD)) {
      sin[place] = Math.sin(angle);
      cos[place] = Math.cos(angle);
      return;
    }
    int nearest = (int) (angle * STEPS_PER_RAD + (MIDDLE + 0.5));
    double rest = angle - (nearest - MIDDLE) * STEP_RAD;
    double square = rest * rest;
    double sine = rest - rest * square * (1 / 6.0 - square * (1 / 120.0 - square * (1 / 5040.0)));
    double versine = square * (1 / 2.0 - square * (1 / 24.0 - square * (1 / 720.0)));
    sin[place] = SIN[nearest] + (COS[nearest] * sine - SIN[nearest] * versine);
    cos[place] = COS[nearest] - (SIN[nearest] * sine + COS[nearest] * versine);
  }
}
