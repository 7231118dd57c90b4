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
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    if (timeS < blendAtS) {
      return first.sample(firstBeginS + timeS, sample);
    }
    return timeS < nextAtS
        ? blend.sample(timeS - blendAtS, sample)
        : next.sample(timeS - nextAtS, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return next.waypoint();
  }
}
