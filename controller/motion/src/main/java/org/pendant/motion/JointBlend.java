package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/** Blend in joint space, from one path to the next. */
final class JointBlend implements Motion {
  private final Hermite joints;
  private final Pose waypoint;

  JointBlend(Hermite joints, Pose waypoint) {
    this.joints = joints;
    this.waypoint = waypoint;
  }

  /** Between two points of two paths, each with the speeds there. */
  static JointBlend between(
      MotionSample from, MotionSample to, double lastsS, boolean smooth, Pose waypoint) {
    return new JointBlend(
        Hermite.of(
            from.position.clone(),
            from.speed.clone(),
            to.position.clone(),
            to.speed.clone(),
            lastsS,
            smooth),
        waypoint);
  }

  @Override
  public double durationS() {
    return joints.durationS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    joints.at(timeS, sample.position, sample.speed, sample.acceleration);
    return Optional.empty();
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(waypoint);
  }
}
