package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Joint stop: all joints slow down evenly and stop at the same moment (manual 15.51); the fastest
 * one with the deceleration asked for.
 */
public final class StopJ implements Motion {
  private final Joints from;
  private final Joints speed;
  private final double durationS;

  /**
   * A stop.
   *
   * @param positionRad where it begins, rad
   * @param speedRadPerS speeds at its start, rad/s
   * @param decelerationRadPerS2 of the fastest joint, above 0
   */
  public StopJ(Joints positionRad, Joints speedRadPerS, double decelerationRadPerS2) {
    from = positionRad;
    speed = speedRadPerS;
    durationS = speedRadPerS.maxAbsDifference(Joints.ZERO) / decelerationRadPerS2;
  }

  @Override
  public double durationS() {
    return durationS;
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (durationS == 0) {
      from.copyTo(sample.position);
      sample.rest();
      return Optional.empty();
    }
    double left = durationS - timeS;
    double travelled = 0.5 * (durationS - left * left / durationS);
    for (int i = 0; i < Joints.COUNT; i++) {
      sample.position[i] = from.get(i) + speed.get(i) * travelled;
      sample.speed[i] = speed.get(i) * left / durationS;
      sample.acceleration[i] = left > 0 ? -speed.get(i) / durationS : 0;
    }
    return Optional.empty();
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.empty();
  }
}
