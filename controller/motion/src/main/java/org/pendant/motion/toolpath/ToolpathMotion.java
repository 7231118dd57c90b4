package org.pendant.motion.toolpath;

import java.util.Optional;
import java.util.function.DoubleSupplier;
import org.pendant.models.pose.Pose;
import org.pendant.motion.Motion;
import org.pendant.motion.MotionFailure;
import org.pendant.motion.MotionSample;
import org.pendant.motion.ToolPathFollower;

/** Toolpath motion: a run of queued motions, from rest to rest. */
final class ToolpathMotion implements Motion {
  private final Chain chain;
  private final SpeedLaw law;
  private final ToolPathFollower follower;
  private final Pose goal;
  private final DoubleSupplier speedFactor;

  /**
   * A run.
   *
   * @param follower of the way in the base frame, over the chain's parameter
   * @param goal of the active TCP, in the base frame
   * @param speedFactor asked each frame, 0 to 1
   */
  ToolpathMotion(
      Chain chain, SpeedLaw law, ToolPathFollower follower, Pose goal, DoubleSupplier speedFactor) {
    this.chain = chain;
    this.law = law;
    this.follower = follower;
    this.goal = goal;
    this.speedFactor = speedFactor;
  }

  @Override
  public double durationS() {
    return law.durationS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    double at = law.position(timeS);
    Optional<MotionFailure> failure =
        follower.sample(at, law.speed(timeS), law.acceleration(timeS), sample);
    return failure.isEmpty() ? failure : Optional.of(named(failure.get(), chain.name(at)));
  }

  /** A failure with the motion in which it happens. */
  static MotionFailure named(MotionFailure failure, String name) {
    return new MotionFailure(failure.code(), name + ": " + failure.message());
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(goal);
  }

  @Override
  public double speedFactor() {
    return speedFactor.getAsDouble();
  }
}
