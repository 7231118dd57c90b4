package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/**
 * Settling motion: the end of a move that nothing blends with after all, from its hand-over to
 * rest.
 */
final class Settling implements Motion {
  private final PathMotion move;

  Settling(PathMotion move) {
    this.move = move;
  }

  @Override
  public double durationS() {
    return move.durationS() - move.handOverS();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    return move.sample(move.handOverS() + timeS, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return move.waypoint();
  }
}
