package org.pendant.motion;

import org.pendant.models.time.FrameTime;

/**
 * Start ramp: the time scale with which a program begins. It rises evenly from 0 to 1 while the
 * first 0.160 s of the program pass, whatever the program does in them. As on recorded arms, to all
 * their digits, a frame moves time on by the scale with which it begins, and its speeds are those
 * of the scale with which it ends.
 */
public final class StartRamp {
  /** How long it takes, s. */
  public static final double DURATION_S = 0.160;

  private static final long FRAMES = FrameTime.framesFor(DURATION_S);

  private long frame = FRAMES;
  private double scale = 1;
  private double scaleBefore = 1;

  /**
   * A program begins. One that begins a frame after another continues its ramp: in the first frame
   * nothing moves, and programs that replace each other in every frame would never move.
   */
  void begin() {
    if (frame == 1) {
      return;
    }
    frame = 0;
    scale = 0;
    scaleBefore = 0;
  }

  /** What is left of it is left out. */
  void end() {
    frame = FRAMES;
    scale = 1;
    scaleBefore = 1;
  }

  /** A frame begins. */
  void step() {
    frame = Math.min(frame + 1, FRAMES);
    scaleBefore = scale;
    scale = (double) frame / FRAMES;
  }

  /** The scale at the end of this frame, 0 to 1; 1 without a ramp. */
  double scale() {
    return scale;
  }

  /** The scale at the end of the frame before. */
  double scaleBefore() {
    return scaleBefore;
  }
}
