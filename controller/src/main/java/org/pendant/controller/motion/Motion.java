package org.pendant.controller.motion;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/**
 * A planned motion: joint positions as a closed form over the motion's own time, which runs slower
 * than the clock when the speed is scaled down and stands still in a pause.
 */
public interface Motion {

  /** When it ends, s in its own time. */
  double durationS();

  /**
   * The point at a time of its own, which goes on from one call to the next, or back by less than a
   * frame. At {@link #durationS} it is the goal itself.
   *
   * @param timeS 0 to {@link #durationS}
   * @param sample overwritten
   * @return why there is no such point, empty when there is
   */
  Optional<MotionFailure> sample(double timeS, MotionSample sample);

  /** Where the TCP goes, in the base frame; empty for motions without a goal (manual 16.31). */
  Optional<Pose> waypoint();

  /**
   * When whoever asked for the motion goes on, s in its own time: where it can blend into the next,
   * otherwise its end.
   */
  default double handOverS() {
    return durationS();
  }

  /**
   * What the arm does when nobody takes the motion over in the frame after the hand-over; empty for
   * going on to its own end.
   */
  default Optional<MotionPlan> ending() {
    return Optional.empty();
  }

  /** The move that a next one may blend with from {@link #handOverS} on; empty if none may. */
  default Optional<PathMotion> leaving() {
    return Optional.empty();
  }
}
