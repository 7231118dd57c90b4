package org.pendant.motion.servo;

import java.util.Arrays;
import org.pendant.models.pose.Rotations;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.ToolCurve;

/**
 * Twist ramp: a path of the TCP whose velocity changes evenly from one to another and then stays;
 * its parameter is time in s, which increases from call to call, or decreases by less than a frame.
 *
 * <p>The position is a closed form. The orientation has none while the axis of turning changes: it
 * is turned on in steps of a frame by the mean angular velocity of each, which is exact to the
 * second order and for a constant axis altogether. (A. Iserles et al., "Lie-group methods", Acta
 * Numerica 2000, section 4: the Magnus method of order 2.)
 */
final class TwistRamp implements ToolCurve {
  private static final int N = 6;

  private final double[] start = new double[Transforms.SIZE];
  private final double[] begin = new double[N];
  private final double[] end = new double[N];
  private double rampS;

  /** The orientation {@link #steps} frames after the start, and a frame before that. */
  private double[] turned = new double[Transforms.SIZE];

  private double[] turnedBefore = new double[Transforms.SIZE];
  private int steps;

  private final double[] rampEnd = new double[Transforms.SIZE];
  private boolean rampEndKnown;
  private final double[] turn = new double[Transforms.SIZE];

  /**
   * Begins another way.
   *
   * @param tcpInBase transformation at its start
   * @param fromTwist velocity there, m/s and rad/s along the axes of the base
   * @param toTwist velocity after the ramp
   * @param lastsS duration of the ramp, s, at least 0
   */
  void begin(double[] tcpInBase, double[] fromTwist, double[] toTwist, double lastsS) {
    System.arraycopy(tcpInBase, 0, start, 0, Transforms.SIZE);
    System.arraycopy(fromTwist, 0, begin, 0, N);
    System.arraycopy(toTwist, 0, end, 0, N);
    rampS = lastsS;
    steps = 0;
    System.arraycopy(start, 0, turned, 0, Transforms.SIZE);
    System.arraycopy(start, 0, turnedBefore, 0, Transforms.SIZE);
    rampEndKnown = lastsS == 0;
    if (rampEndKnown) {
      System.arraycopy(start, 0, rampEnd, 0, Transforms.SIZE);
    }
  }

  @Override
  public void at(double timeS, double[] transform) {
    if (timeS <= rampS) {
      turnOnRamp(timeS, transform);
    } else {
      if (!rampEndKnown) {
        turnOnRamp(rampS, rampEnd);
        rampEndKnown = true;
      }
      turn(rampEnd, end[3], end[4], end[5], timeS - rampS, transform);
    }
    double changedS = timeS < rampS ? 0.5 * timeS * timeS / rampS : timeS - 0.5 * rampS;
    for (int i = 0; i < 3; i++) {
      transform[9 + i] = start[9 + i] + begin[i] * timeS + (end[i] - begin[i]) * changedS;
    }
  }

  /** Writes the orientation at a time on the ramp. */
  private void turnOnRamp(double timeS, double[] transform) {
    while ((steps + 1) * FrameTime.FRAME_S < timeS) {
      double[] next = turnedBefore;
      turnBetween(turned, steps * FrameTime.FRAME_S, (steps + 1) * FrameTime.FRAME_S, next);
      turnedBefore = turned;
      turned = next;
      steps++;
    }
    double stepS = steps * FrameTime.FRAME_S;
    if (timeS >= stepS) {
      turnBetween(turned, stepS, timeS, transform);
    } else {
      turnBetween(turnedBefore, stepS - FrameTime.FRAME_S, timeS, transform);
    }
  }

  private void turnBetween(double[] from, double fromS, double toS, double[] to) {
    double middle = rampS > 0 ? 0.5 * (fromS + toS) / rampS : 1;
    turn(from, mean(3, middle), mean(4, middle), mean(5, middle), toS - fromS, to);
  }

  private void turn(double[] from, double wx, double wy, double wz, double lastsS, double[] to) {
    Rotations.vectorToMatrix(wx * lastsS, wy * lastsS, wz * lastsS, turn);
    Transforms.multiply(turn, from, to);
  }

  private double mean(int i, double share) {
    return begin[i] + share * (end[i] - begin[i]);
  }

  @Override
  public void rate(double timeS, double[] twist) {
    double share = timeS < rampS ? timeS / rampS : 1;
    for (int i = 0; i < N; i++) {
      twist[i] = share == 1 ? end[i] : mean(i, share);
    }
  }

  @Override
  public void bend(double timeS, double[] twist) {
    if (rampS == 0 || timeS > rampS) {
      Arrays.fill(twist, 0);
      return;
    }
    for (int i = 0; i < N; i++) {
      twist[i] = (end[i] - begin[i]) / rampS;
    }
  }
}
