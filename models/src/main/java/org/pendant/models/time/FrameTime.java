package org.pendant.models.time;

/** Frame time: the controller's step in time. */
public final class FrameTime {
  /** Length of a frame, s. */
  public static final double FRAME_S = 0.002;

  /** Frames per second. */
  public static final int FRAMES_PER_SECOND = 500;

  /** Part of a frame that counts as rounding when a duration is a whole number of frames. */
  public static final double ROUNDING = 1e-9;

  private FrameTime() {}

  /** The whole frames that cover a duration (s), at least one. */
  public static long framesFor(double durationS) {
    return Math.max(1, (long) Math.ceil(durationS / FRAME_S - ROUNDING));
  }
}
