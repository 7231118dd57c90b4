package org.pendant.controller.motion;

import org.pendant.models.arm.Joints;

/** Where the path is and how fast the joints turn there, by the clock; in rad and s. */
final class PathPoint {
  private Joints position;
  private Joints speed = Joints.ZERO;
  private Joints acceleration = Joints.ZERO;

  /** At rest at {@code positionRad}. */
  PathPoint(Joints positionRad) {
    position = positionRad;
  }

  Joints position() {
    return position;
  }

  Joints speed() {
    return speed;
  }

  Joints acceleration() {
    return acceleration;
  }

  /** Whether any joint turns. */
  boolean moves() {
    return !speed.equals(Joints.ZERO);
  }

  void set(Joints positionRad, Joints speedRadPerS, Joints accelerationRadPerS2) {
    position = positionRad;
    speed = speedRadPerS;
    acceleration = accelerationRadPerS2;
  }

  /** Stands still where it is. */
  void rest() {
    restAt(position);
  }

  /** Stands still elsewhere. */
  void restAt(Joints positionRad) {
    set(positionRad, Joints.ZERO, Joints.ZERO);
  }

  /**
   * Takes over a point of a motion, whose own time runs slower than the clock.
   *
   * @param sample the point, with derivatives by the motion's own time
   * @param scaling of that time, 0 to 1
   * @param scalingPerS how fast the scaling changes, 1/s
   */
  void follow(MotionSample sample, double scaling, double scalingPerS) {
    double[] v = sample.speed;
    position = Joints.of(sample.position);
    speed = sum(scaling, v, 0, v);
    acceleration = sum(scaling * scaling, sample.acceleration, scalingPerS, v);
  }

  /** The speed by a motion's own time that runs with {@code scaling}, above 0; rad/s. */
  Joints speedInOwnTime(double scaling) {
    return new Joints(
        speed.q0() / scaling,
        speed.q1() / scaling,
        speed.q2() / scaling,
        speed.q3() / scaling,
        speed.q4() / scaling,
        speed.q5() / scaling);
  }

  private static Joints sum(double f, double[] x, double g, double[] y) {
    Joints sum =
        new Joints(
            f * x[0] + g * y[0],
            f * x[1] + g * y[1],
            f * x[2] + g * y[2],
            f * x[3] + g * y[3],
            f * x[4] + g * y[4],
            f * x[5] + g * y[5]);
    return isZero(sum) ? Joints.ZERO : sum;
  }

  /** Unlike {@code equals} this takes -0 for 0. */
  private static boolean isZero(Joints q) {
    return q.q0() == 0 && q.q1() == 0 && q.q2() == 0 && q.q3() == 0 && q.q4() == 0 && q.q5() == 0;
  }
}
