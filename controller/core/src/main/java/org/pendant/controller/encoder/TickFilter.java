package org.pendant.controller.encoder;

import org.pendant.models.time.FrameTime;

/**
 * Tick filter: follows a count smoothly: between two ticks, and between two readings of an encoder
 * that is read seldom, the belt is taken to continue as fast as it did. At an even speed nothing
 * lags behind.
 *
 * <p>A filter with fading memory for position and speed (E. Brookner, "Tracking and Kalman
 * Filtering Made Easy", chapter 1.2.6), corrected when the count changes. When it changes no longer
 * it is corrected in every frame, so that the filtered count comes to rest on the count.
 */
final class TickFilter {
  /** How long it remembers, s. */
  private static final double MEMORY_S = 0.03;

  /** The longest time without a tick before a belt counts as standing, s. */
  private static final double MAX_GAP_S = 0.1;

  /** As the same, in gaps between the ticks before. */
  private static final double MAX_GAPS = 2;

  /** Slower than this, and nearer to the count, the belt stands, ticks/s and ticks. */
  private static final double STANDS = 1e-9;

  private long count;
  private double position;
  private double ticksPerS;
  private double gapS = MAX_GAP_S;
  private double sinceTickS = MAX_GAP_S;
  private double sinceCorrectionS;

  /** The count jumps: it has been set. */
  void jumpTo(long ticks) {
    count = ticks;
    position = ticks;
    ticksPerS = 0;
    gapS = MAX_GAP_S;
    sinceTickS = MAX_GAP_S;
    sinceCorrectionS = 0;
  }

  /** A frame later, with the count then. */
  void step(long ticks) {
    sinceTickS += FrameTime.FRAME_S;
    sinceCorrectionS += FrameTime.FRAME_S;
    position += ticksPerS * FrameTime.FRAME_S;
    boolean ticked = ticks != count;
    count = ticks;
    if (ticked) {
      gapS = Math.min(MAX_GAP_S, sinceTickS);
      sinceTickS = 0;
    }
    if (ticked || sinceTickS > Math.min(MAX_GAP_S, MAX_GAPS * gapS)) {
      correct();
    }
  }

  private void correct() {
    double elapsedS = Math.min(sinceCorrectionS, MAX_GAP_S);
    double fading = Math.exp(-elapsedS / MEMORY_S);
    double error = count - position;
    position += (1 - fading * fading) * error;
    ticksPerS += (1 - fading) * (1 - fading) * error / elapsedS;
    sinceCorrectionS = 0;
    if (Math.abs(ticksPerS) < STANDS && Math.abs(count - position) < STANDS) {
      position = count;
      ticksPerS = 0;
    }
  }

  /** The filtered count. */
  double position() {
    return position;
  }
}
