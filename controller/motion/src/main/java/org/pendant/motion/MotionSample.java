package org.pendant.motion;

import java.util.Arrays;
import org.pendant.models.arm.Joints;

/**
 * Sample of a motion, per joint: position in rad, and its first and second derivative by the
 * motion's own time in rad/s and rad/s². Motions write into it.
 */
public final class MotionSample {
  private static final double[][] UNKNOWN = {};

  final double[] position = new double[Joints.COUNT];
  final double[] speed = new double[Joints.COUNT];
  final double[] acceleration = new double[Joints.COUNT];

  /**
   * Frames of the links at {@link #position}, if the motion has found them out; they are the
   * motion's own, and others when it is sampled again.
   */
  private double[][] frames = UNKNOWN;

  /** The motion knows how the links stand. */
  void setFrames(double[][] ofLinks) {
    frames = ofLinks;
  }

  /** It is not known yet how the links stand. */
  void forgetFrames() {
    frames = UNKNOWN;
  }

  /** The largest scaling that a limiter allows at this point. */
  double largestScaling(PathLimiter limiter) {
    return frames.length == 0
        ? limiter.largestScaling(position, speed)
        : limiter.largestScaling(position, speed, frames);
  }

  /** Joint positions, rad. */
  public Joints positionRad() {
    return Joints.of(position);
  }

  /** Joint speeds, rad/s. */
  public Joints speedRadPerS() {
    return Joints.of(speed);
  }

  /** Joint accelerations, rad/s². */
  public Joints accelerationRadPerS2() {
    return Joints.of(acceleration);
  }

  /** Sets one joint: position in rad, speed in rad/s, acceleration in rad/s². */
  public void set(int joint, double q, double qd, double qdd) {
    position[joint] = q;
    speed[joint] = qd;
    acceleration[joint] = qdd;
  }

  /** Speed of the fastest joint, rad/s. */
  double fastestRadPerS() {
    double fastest = 0;
    for (double each : speed) {
      fastest = Math.max(fastest, Math.abs(each));
    }
    return fastest;
  }

  /** Takes over another point. */
  void copy(MotionSample other) {
    System.arraycopy(other.position, 0, position, 0, Joints.COUNT);
    System.arraycopy(other.speed, 0, speed, 0, Joints.COUNT);
    System.arraycopy(other.acceleration, 0, acceleration, 0, Joints.COUNT);
  }

  void rest() {
    Arrays.fill(speed, 0);
    Arrays.fill(acceleration, 0);
  }
}
