package org.pendant.recording.explain;

import java.util.Optional;
import org.pendant.controller.safety.SpeedUse;

/**
 * Cause: what set the speed of the arm at a moment.
 *
 * @param certain whether the frames say so; otherwise it is likely
 * @param value the speed or acceleration that was wanted or reached, in m or rad and s; NaN for
 *     none
 * @param asked what the command asks for, in the same unit; NaN where the line does not say it
 * @param use the limit that was met, where it is one
 */
public record Cause(
    Kind kind, boolean certain, double value, double asked, Optional<SpeedUse> use) {
  /** What it was. */
  public enum Kind {
    /** Nothing moves. */
    REST,
    /** A hand guides the arm. */
    HAND,
    /** Torques of the program drive it. */
    TORQUE,
    /** A safety function brings it to rest. */
    SAFETY_STOP,
    /** The program is paused or has ended, and the arm comes to rest. */
    PAUSE,
    /** The first moments of a program. */
    START_RAMP,
    /** A limit that slows motions down. */
    SAFETY_LIMIT,
    /** The speed comes to what the slider and pauses want, at the rate that is usual. */
    SCALING_RAMP,
    /** Less than the slider wants, and none of the limits that are known is met. */
    SCALING,
    /** The speed of the command, as far as the slider lets it. */
    COMMAND_SPEED,
    /** The speed that makes the move take as long as the command says. */
    COMMAND_TIME,
    /** A speed that the program sets by itself, frame by frame. */
    STREAMED,
    /** A speed below that of the command: a joint turns as fast as it can. */
    JOINT_LIMIT,
    /** Between speeding up and slowing down: the way is too short for the speed of the command. */
    SHORT_WAY,
    /** A speed below that of the command: what drives can do along the path, or a blend. */
    PATH_LIMIT,
    /** It speeds up. */
    ACCELERATION,
    /** It slows down, for the end of the move or a corner. */
    DECELERATION
  }

  /** Whether the command asks for just what happens. */
  public boolean asTheCommandSays() {
    return MotionExplanation.same(value, asked);
  }

  static Cause certain(Kind kind) {
    return of(kind, true, Double.NaN);
  }

  static Cause of(Kind kind, boolean certain, double value) {
    return new Cause(kind, certain, value, Double.NaN, Optional.empty());
  }

  Cause asking(double other) {
    return new Cause(kind, certain, value, other, use);
  }

  static Cause met(Kind kind, SpeedUse use) {
    return new Cause(kind, true, use.value(), Double.NaN, Optional.of(use));
  }
}
