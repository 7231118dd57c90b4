package org.pendant.protocols.rtde;

/**
 * Pacing: chooses the frames in which something is due that comes less often than frames do: as
 * evenly as frames allow, the first one immediately. A frequency that does not divide 500 Hz is
 * kept on average.
 */
final class Pacing {
  /** How often frames come, Hz. */
  static final double FRAMES_HZ = 500;

  /** Sums of fractions may come out a little less than they are. */
  private static final double ROUNDING_HZ = 1e-6;

  private final double frequencyHz;
  private double progressHz;

  /** A pace of 1 to 500 Hz. */
  Pacing(double frequencyHz) {
    this.frequencyHz = frequencyHz;
    progressHz = FRAMES_HZ - frequencyHz;
  }

  /** Whether it is due in the frame that has come. */
  boolean due() {
    progressHz += frequencyHz;
    if (progressHz < FRAMES_HZ - ROUNDING_HZ) {
      return false;
    }
    progressHz -= FRAMES_HZ;
    return true;
  }
}
