package org.pendant.desktop.unit;

import org.pendant.models.time.FrameTime;

/** Time step: how far times that are drawn or typed by mouse stand apart, in round numbers. */
public final class TimeStep {
  private TimeStep() {}

  /** The next of 1, 2 and 5 times a power of ten, s: at least {@code leastS}, and a frame. */
  public static double atLeast(double leastS) {
    double power = Math.pow(10, Math.floor(Math.log10(leastS)));
    for (double each : new double[] {1, 2, 5}) {
      if (each * power >= leastS) {
        return Math.max(FrameTime.FRAME_S, each * power);
      }
    }
    return Math.max(FrameTime.FRAME_S, 10 * power);
  }
}
