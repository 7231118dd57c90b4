package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/** The rest of a move up to where the next takes over, the blend between them, and the next. */
final class JoinedMotion implements Motion {
  private final PathMotion first;
  private final double firstBeginS;
  private final Motion blend;
  private final PathMotion next;
  private final double blendAtS;
  private final double nextAtS;

  /**
   * Joins two moves.
   *
   * @param firstBeginS where the first one is, s in its own time, before its hand-over
   * @param blend from the point of the hand-over to the begin of {@code next}
   */
  JoinedMotion(PathMotion first, double firstBeginS, Motion blend, PathMotion next) {
    this.first = first;
    this.firstBeginS = firstBeginS;
    this.blend = blend;
    this.next = next;
    blendAtS = first.handOverS() - firstBeginS;
    nextAtS = blendAtS + blend.durationS();
  }

  @Override
  public double durationS() {
    return nextAtS + next.durationS();
  }

  @Override
  public double handOverS() {
    return nextAtS + next.handOverS();
  }

  @Override
  public Optional<PathMotion> leaving() {
    return next.leaving();
  }

  @Override
  public double stretchedS() {
    return next.stretchedS();
  }

  @Override
  public Optional<Motion> cutShort(double timeS) {
    return timeS < nextAtS ? Optional.empty() : next.cutShort(timeS - nextAtS);
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (timeS < blendAtS) {
      return first.sample(firstBeginS + timeS, sample);
    }
    if (timeS < nextAtS) {
      return blend.sample(timeS - blendAtS, sample);
    }
    // the sum of the durations may be rounded down, and the end is to be met exactly
    return next.sample(timeS >= durationS() ? next.durationS() : timeS - nextAtS, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return next.waypoint();
  }
}
