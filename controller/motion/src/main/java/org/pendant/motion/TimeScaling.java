package org.pendant.motion;

import org.pendant.models.time.FrameTime;

/**
 * Time scaling: how fast a trajectory's own time runs against the clock. Speed slider, pauses and
 * stops set the scaling that is wanted; the scaling follows it in ramps within the limits of the
 * joints. The rate of time is the scaling times that of the program's {@link StartRamp}, which no
 * reading of the scaling shows.
 */
final class TimeScaling {
  private final StartRamp startRamp = new StartRamp();
  private double fraction = 1;

  /** What the motion itself makes of the slider. */
  private double factor = 1;

  private double scaling = 1;
  private double rampRadPerS2 = MotionControl.SCALING_ACCELERATION_RAD_PER_S2;
  private boolean paused;

  /** The motion is a stop: neither slider nor pause makes it longer. */
  private boolean stopping;

  /** In the last frame a limit of the arm allowed less than there would have been. */
  private boolean limited;

  /** No caller wants the motion any more: it ends where the scaling reaches 0. */
  private boolean releasing;

  /** A motion begins at the scaling that it is to have. */
  void begin(boolean stop) {
    stopping = stop;
    releasing = false;
    scaling = goal();
  }

  /** A motion begins where another one is, at the same scaling. */
  void continueScaling() {
    stopping = false;
    releasing = false;
  }

  /**
   * The scaling at which a motion takes over from whatever moves the arm: what is there, so that no
   * joint jumps and a ramp of the slider continues; but no less than wanted where a limit or an end
   * that no caller wants any more has kept it down, or there was none, so that it does not crawl
   * up.
   *
   * @param unscaled whether the arm moves without scaling now
   * @param share of what the joints can do that the arm moves at; an unscaled speed counts as no
   *     more than all of it in the new motion's own time
   */
  double continuedScaling(boolean unscaled, double share) {
    if (unscaled) {
      return Math.max(Math.min(1, share), wanted());
    }
    return limited || releasing ? Math.max(scaling, wanted()) : scaling;
  }

  /** A motion begins at a scaling. */
  void continueAt(double begin) {
    continueScaling();
    scaling = begin;
  }

  /** What the scaling of a motion that is no stop goes to. */
  double wanted() {
    return paused ? 0 : fraction * factor;
  }

  private double goal() {
    if (stopping) {
      return 1;
    }
    return releasing ? 0 : wanted();
  }

  /**
   * Goes a frame on towards the goal.
   *
   * @param fastestRadPerS speed of the fastest joint when the scaling is 1
   */
  void step(double fastestRadPerS) {
    limited = false;
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

  /** The limits of the arm allow no higher rate in this frame. */
  void limitRateTo(double possible) {
    scaling = possible / start();
    limited = true;
  }

  /** No greater change of the rate is allowed in this frame. */
  void changeRateTo(double reachable) {
    scaling = reachable / start();
  }

  /** What the speed slider and the like make of the rate. */
  double scaling() {
    return scaling;
  }

  /** How fast motion time runs against the clock at the end of this frame. */
  double rate() {
    return scaling * start();
  }

  /** The same at the end of the frame before, asked before {@link #step}. */
  double rateBefore() {
    return stopping ? scaling : scaling * startRamp.scaleBefore();
  }

  /** What the start of the program makes of the rate in this frame; above 0 where time runs. */
  double start() {
    return stopping ? 1 : startSoFar();
  }

  /** What the start of the program makes of the rate of a motion that is no stop. */
  double startSoFar() {
    return startRamp.scale();
  }

  /** The same as {@link #start} at the end of the frame before; 0 in the first of a program. */
  double startBefore() {
    return stopping ? 1 : startRamp.scaleBefore();
  }

  /** A program begins with an arm at rest. */
  void beginStartRamp() {
    startRamp.begin();
  }

  /** The program is past its start. */
  void endStartRamp() {
    startRamp.end();
  }

  /** A frame of the clock begins, whether there is a motion or not. */
  void stepStartRamp() {
    startRamp.step();
  }

  boolean stopping() {
    return stopping;
  }

  boolean paused() {
    return paused;
  }

  /** How fast a change of the scaling may slow down the fastest joint now, rad/s². */
  double rampRadPerS2() {
    return rampRadPerS2;
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
    if (!releasing) {
      // what comes to rest for good continues as hard as it began
      rampRadPerS2 = MotionControl.SCALING_ACCELERATION_RAD_PER_S2;
    }
  }

  /** How much of its speed the motion wants by itself, 0 to 1. */
  void setFactor(double ofMotion) {
    factor = ofMotion;
  }

  double fraction() {
    return fraction;
  }

  void setFraction(double slider) {
    fraction = slider;
  }
}
