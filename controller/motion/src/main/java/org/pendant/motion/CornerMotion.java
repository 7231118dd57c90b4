package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/**
 * Motion up to a corner: at an even speed to the end of a path, or up to a curve near it and along
 * that.
 */
final class CornerMotion implements Motion {
  private final MotionPath before;
  private final double begin;
  private final double straightS;
  private final double rate;
  private final Pose waypoint;
  private final Optional<ToolPathFollower> curve;
  private final double speedMPerS;
  private final double durationS;

  private CornerMotion(
      MotionPath before,
      double begin,
      double straightS,
      double rate,
      Pose waypoint,
      Optional<ToolPathFollower> curve,
      double curveM,
      double speedMPerS) {
    this.before = before;
    this.begin = begin;
    this.straightS = straightS;
    this.rate = rate;
    this.waypoint = waypoint;
    this.curve = curve;
    this.speedMPerS = speedMPerS;
    durationS = straightS + curveM / speedMPerS;
  }

  /**
   * A motion without a curve.
   *
   * @param begin where on the path
   * @param straight how far on it, in its unit
   * @param rate how fast, above 0
   * @param waypoint where the TCP goes afterwards, in the base frame
   */
  CornerMotion(MotionPath before, double begin, double straight, double rate, Pose waypoint) {
    this(before, begin, Math.max(0, straight) / rate, rate, waypoint, Optional.empty(), 0, 1);
  }

  /** This motion and a curve after it, whose parameter is its length, m. */
  CornerMotion thenRound(ToolPathFollower follower, double lengthM, double speed) {
    return new CornerMotion(
        before, begin, straightS, rate, waypoint, Optional.of(follower), lengthM, speed);
  }

  @Override
  public double durationS() {
    return durationS;
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (timeS < straightS || curve.isEmpty()) {
      return before.sample(begin + rate * Math.min(timeS, straightS), rate, 0, sample);
    }
    return curve.get().sample((timeS - straightS) * speedMPerS, speedMPerS, 0, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return Optional.of(waypoint);
  }
}
