package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/**
 * Joined motion: the rest of a move up to where the next takes over, the blend between them, and
 * the next.
 */
final class JoinedMotion implements Motion {
  private final PathMotion first;
  private final double firstBeginS;
  private final Motion blend;
  private final PathMotion next;
  private final double blendAtS;
  private final double nextAtS;

  /** How far the next one is when the blend ends, s in its own time. */
  private final double nextFromS;

  /**
   * Joins two moves.
   *
   * @param firstBeginS where the first one is, s in its own time, before its hand-over
   * @param blend from the point of the hand-over to the start of {@code next}
   */
  JoinedMotion(PathMotion first, double firstBeginS, Motion blend, PathMotion next) {
    this(first, firstBeginS, blend, next, 0);
  }

  /**
   * Joins two moves, the second of which begins during the blend.
   *
   * @param nextFromS where the second one is at the end of {@code blend}, s in its own time
   */
  JoinedMotion(
      PathMotion first, double firstBeginS, Motion blend, PathMotion next, double nextFromS) {
    this.nextFromS = nextFromS;
    this.first = first;
    this.firstBeginS = firstBeginS;
    this.blend = blend;
    this.next = next;
    blendAtS = first.handOverS() - firstBeginS;
    nextAtS = blendAtS + blend.durationS();
  }

  @Override
  public double durationS() {
    return nextAtS - nextFromS + next.durationS();
  }

  @Override
  public double handOverS() {
    return nextAtS - nextFromS + next.handOverS();
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
    return timeS < nextAtS ? Optional.empty() : next.cutShort(timeS - nextAtS + nextFromS);
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
    return next.sample(
        timeS >= durationS() ? next.durationS() : timeS - nextAtS + nextFromS, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return next.waypoint();
  }
}
