package org.pendant.motion;

import static org.pendant.motion.MotionTexts.text;

import java.util.Optional;
import org.pendant.models.pose.Pose;

/**
 * Motion: joint positions as a closed form over the motion's own time, which runs slower than the
 * clock when the speed is scaled down and stands still in a pause.
 */
public interface Motion {

  /** When it ends, s in its own time. */
  double durationS();

  /**
   * The point at a time of its own, which continues from one call to the next, or back by less than
   * a frame. At {@link #durationS} it is the goal itself.
   *
   * @param timeS 0 to {@link #durationS}
   * @param sample overwritten
   * @return why there is no such point, empty when there is
   */
  Optional<MotionFailure> sample(double timeS, MotionSample sample);

  /** Where the TCP goes, in the base frame; empty for motions without a goal (manual 16.31). */
  Optional<Pose> waypoint();

  /**
   * When the caller that asked for the motion continues, s in its own time: where it can blend into
   * the next, otherwise its end.
   */
  default double handOverS() {
    return durationS();
  }

  /**
   * Whether it is handed over after a time that was asked for, so that what it lasts longer, up to
   * the end of the frame, counts for the next one.
   */
  default boolean timed() {
    return false;
  }

  /**
   * What the arm does when no move takes the motion over in the frame after the hand-over; empty
   * for continuing to its own end.
   */
  default Optional<MotionPlan> ending() {
    return Optional.empty();
  }

  /**
   * How long the whole way takes when a duration was asked for that is too short, s; otherwise 0.
   */
  default double stretchedS() {
    return 0;
  }

  /**
   * This motion as it is when its waypoint does not matter any more: handed over at once, and at
   * rest as soon as any next move may need it.
   *
   * @param timeS how far it is, s in its own time
   * @return empty if it has no blend radius, or is not yet after the blend that it began with
   */
  default Optional<Motion> cutShort(double timeS) {
    return Optional.empty();
  }

  /**
   * How much of its speed it wants, 0 to 1, asked in each frame: one that was planned for full
   * speed and that is made slower as it goes, as by {@code mc_set_speed_factor}. A change is
   * reached in a ramp.
   */
  default double speedFactor() {
    return 1;
  }

  /** The function that keeps the arm moving after the hand-over, for messages. */
  default String driver() {
    return text("anotherMotion");
  }

  /** The move that a next one may blend with from {@link #handOverS} on; empty if none may. */
  default Optional<PathMotion> leaving() {
    return Optional.empty();
  }
}
