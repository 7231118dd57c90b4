package org.pendant.motion;

import java.util.Arrays;
import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;
import org.pendant.models.time.FrameTime;

/**
 * Stop of an arm that offsets carry and a safety function stops: all joints slow down in proportion
 * and stay. What has come between them and where offsets want them meanwhile is closed smoothly
 * afterwards.
 */
final class OffsetHold {
  /** How fast the fastest joint may close the gap, rad/s. */
  private static final double CLOSING_RAD_PER_S = 0.5;

  /** The shortest time for it, s. */
  private static final double MIN_S = 0.4;

  /** Highest over mean speed of the polynomial below. */
  private static final double PEAK_OVER_MEAN = 1.875;

  private enum Phase {
    IDLE,
    HOLDING,
    LET_GO,
    CLOSING
  }

  private final double[] aside = new double[Joints.COUNT];
  private Phase phase = Phase.IDLE;
  private double decelerationRadPerS2;
  private double closed;
  private double closedPerFrame;

  void begin(double deceleration) {
    phase = Phase.HOLDING;
    decelerationRadPerS2 = deceleration;
  }

  boolean holding() {
    return phase == Phase.HOLDING;
  }

  void end() {
    if (phase == Phase.HOLDING) {
      phase = Phase.LET_GO;
    }
  }

  void clear() {
    phase = Phase.IDLE;
  }

  /** The next positions of joints that slow down. */
  void step(JointNumbers position, JointNumbers speed, double[] next) {
    double fastest = speed.largest();
    double step = decelerationRadPerS2 * FrameTime.FRAME_S;
    double part = fastest > step ? 1 - step / fastest : 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      next[i] = position.numbers()[i] + part * speed.numbers()[i] * FrameTime.FRAME_S;
    }
  }

  /**
   * Leads from where the joints were stopped to where offsets want them.
   *
   * @param held where they stand, rad
   * @param wanted where they are to be, rad; changed to where they shall be in this frame
   */
  void leadBack(double[] held, double[] wanted) {
    switch (phase) {
      case IDLE, HOLDING -> {}
      case LET_GO -> {
        beginClosing(held, wanted);
        System.arraycopy(held, 0, wanted, 0, Joints.COUNT);
      }
      case CLOSING -> close(wanted);
    }
  }

  private void beginClosing(double[] held, double[] wanted) {
    double farthest = 0;
    for (int i = 0; i < Joints.COUNT; i++) {
      aside[i] = held[i] - wanted[i];
      farthest = Math.max(farthest, Math.abs(aside[i]));
    }
    double lastsS = Math.max(MIN_S, PEAK_OVER_MEAN * farthest / CLOSING_RAD_PER_S);
    closed = 0;
    closedPerFrame = FrameTime.FRAME_S / lastsS;
    phase = Phase.CLOSING;
  }

  private void close(double[] wanted) {
    closed += closedPerFrame;
    if (closed >= 1) {
      Arrays.fill(aside, 0);
      phase = Phase.IDLE;
      return;
    }
    double u = closed;
    double left = 1 - u * u * u * (10 + u * (-15 + 6 * u));
    for (int i = 0; i < Joints.COUNT; i++) {
      wanted[i] += left * aside[i];
    }
  }
}
