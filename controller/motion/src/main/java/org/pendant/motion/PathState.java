package org.pendant.motion;

import org.pendant.models.arm.JointNumbers;
import org.pendant.models.arm.Joints;

/**
 * Path state: joint positions, speeds and accelerations of the path in a frame, by the clock; in
 * rad and s.
 */
final class PathState {
  private final JointNumbers position = new JointNumbers();
  private final JointNumbers speed = new JointNumbers();
  private final JointNumbers acceleration = new JointNumbers();

  /** At rest at {@code positionRad}. */
  PathState(Joints positionRad) {
    position.set(positionRad);
  }

  JointNumbers position() {
    return position;
  }

  JointNumbers speed() {
    return speed;
  }

  JointNumbers acceleration() {
    return acceleration;
  }

  /** Whether any joint turns. */
  boolean moves() {
    return !speed.isZero();
  }

  void set(Joints positionRad, Joints speedRadPerS, Joints accelerationRadPerS2) {
    position.set(positionRad);
    speed.set(speedRadPerS);
    acceleration.set(accelerationRadPerS2);
  }

  /** Stands still where it is. */
  void rest() {
    speed.setZero();
    acceleration.setZero();
  }

  /** Stands still elsewhere. */
  void restAt(Joints positionRad) {
    position.set(positionRad);
    rest();
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
    position.set(sample.position);
    speed.setSum(scaling, v, 0, v);
    acceleration.setSum(scaling * scaling, sample.acceleration, scalingPerS, v);
  }

  /** The speed by a motion's own time that runs with {@code scaling}, above 0; rad/s. */
  Joints speedInOwnTime(double scaling) {
    double[] v = speed.numbers();
    return new Joints(
        v[0] / scaling,
        v[1] / scaling,
        v[2] / scaling,
        v[3] / scaling,
        v[4] / scaling,
        v[5] / scaling);
  }
}
