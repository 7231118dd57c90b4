package org.pendant.controller.motion;

/**
 * How fast a motion's own time runs against the clock: the slider, pauses and stops decide, and the
 * scaling follows in ramps that the joints can do.
 */
final class PathTime {
  private double fraction = 1;
  private double scaling = 1;
  private double rampRadPerS2 = MotionControl.SCALING_ACCELERATION_RAD_PER_S2;
  private boolean paused;

  /** The motion is a stop: neither slider nor pause makes it longer. */
  private boolean stopping;

  /** Nobody wants the motion any more: it ends where the scaling reaches 0. */
  private boolean releasing;

  /** A motion begins at the scaling that it is to have. */
  void begin(boolean stop) {
    stopping = stop;
    releasing = false;
    scaling = goal();
  }

  /** A motion begins where another one is, at the same scaling. */
  void goOn() {
    stopping = false;
    releasing = false;
  }

  private double goal() {
    if (stopping) {
      return 1;
    }
    return paused || releasing ? 0 : fraction;
  }

  /**
   * Goes a frame on towards the goal.
   *
   * @param fastestRadPerS speed of the fastest joint when the scaling is 1
   */
  void step(double fastestRadPerS) {
    double goal = goal();
    if (goal != scaling) {
      double step = rampRadPerS2 * FrameTime.FRAME_S / fastestRadPerS;
      scaling = goal < scaling ? Math.max(goal, scaling - step) : Math.min(goal, scaling + step);
    }
  }

  /** Motion time that passes at least, and twice that at most, until the scaling is 0, s. */
  double untilRestS(double fastestRadPerS) {
    return 0.5 * scaling * scaling * fastestRadPerS / rampRadPerS2;
  }

  /** The limits of the arm allow no more in this frame. */
  void lowerTo(double most) {
    scaling = most;
  }

  double scaling() {
    return scaling;
  }

  boolean stopping() {
    return stopping;
  }

  boolean releasing() {
    return releasing;
  }

  void release() {
    releasing = true;
  }

  void pause(double decelerationRadPerS2) {
    paused = true;
    rampRadPerS2 = decelerationRadPerS2;
  }

  void resume() {
    paused = false;
    rampRadPerS2 = MotionControl.SCALING_ACCELERATION_RAD_PER_S2;
  }

  double fraction() {
    return fraction;
  }

  void setFraction(double wanted) {
    fraction = wanted;
  }
}
