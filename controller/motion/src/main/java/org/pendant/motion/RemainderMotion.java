package org.pendant.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/** Remainder of a move after which another move to the same goal was commanded. */
final class RemainderMotion implements Motion {
  private final PathMotion move;
  private final double beginS;
  private final boolean open;

  /**
   * The rest of a move.
   *
   * @param beginS where the move is, s in its own time
   * @param open whether the next move may still blend with it
   */
  RemainderMotion(PathMotion move, double beginS, boolean open) {
    this.move = move;
    this.beginS = beginS;
    this.open = open;
  }

  @Override
  public double durationS() {
    return move.durationS() - beginS;
  }

  @Override
  public double handOverS() {
    return open ? move.handOverS() - beginS : durationS();
  }

  @Override
  public Optional<PathMotion> leaving() {
    return open ? Optional.of(move) : Optional.empty();
  }

  @Override
  public Optional<MotionFailure> sample(double timeS, MotionSample sample) {
    return move.sample(beginS + timeS, sample);
  }

  @Override
  public Optional<Pose> waypoint() {
    return move.waypoint();
  }
}
