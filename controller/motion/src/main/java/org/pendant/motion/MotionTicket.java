package org.pendant.motion;

import java.util.List;
import java.util.Optional;

/** Motion ticket: tells the caller that asked for a motion whether it has ended, and how. */
public final class MotionTicket {
  private final MotionQueue motionQueue;
  private boolean finished;
  private double stretchedS;
  private Optional<MotionFailure> failure = Optional.empty();

  MotionTicket(MotionQueue motionQueue) {
    this.motionQueue = motionQueue;
  }

  /** Whether the motion is over, at its goal or by {@link #endEarly}; the target rests. */
  public boolean finished() {
    return finished;
  }

  /** Why the motion ended early. */
  public Optional<MotionFailure> failure() {
    return failure;
  }

  /** Lets the arm come to rest on its path; the motion counts as finished then. */
  public void endEarly() {
    motionQueue.endEarly(this);
  }

  /** No caller waits any more: the arm comes to rest on its path. */
  public void cancel() {
    motionQueue.release(this);
  }

  /** Whether the motion has only just begun and may be planned anew, knowing what follows it. */
  public boolean wantsOutlook() {
    return motionQueue.wantsOutlook(this);
  }

  /** The moves that follow the one that has just begun, as far as can be foreseen. */
  public void outlook(List<Move> next) {
    motionQueue.outlook(this, next);
  }

  /** How long the move takes when a shorter duration was asked for, s; otherwise 0. */
  public double stretchedS() {
    return stretchedS;
  }

  void stretchedTo(double leastS) {
    stretchedS = leastS;
  }

  void finish() {
    finished = true;
  }

  void fail(MotionFailure reason) {
    failure = Optional.of(reason);
  }
}
