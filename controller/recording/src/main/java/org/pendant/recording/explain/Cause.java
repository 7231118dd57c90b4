package org.pendant.recording.explain;

import java.util.Optional;
import org.pendant.controller.safety.SpeedUse;

/**
 * Cause: what set the speed of the arm at a moment.
 *
 * @param certain whether the frames say so; otherwise it is likely
 * @param value the speed or acceleration that was wanted or reached, in m or rad and s; NaN for
 *     none
 * @param use the limit that was met, for a safety limit
 */
public record Cause(Kind kind, boolean certain, double value, Optional<SpeedUse> use) {
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
    /** A speed below that of the command: what drives or joints can do along the path. */
    PATH_LIMIT,
    /** It speeds up. */
    ACCELERATION,
    /** It slows down, for the end of the move or a corner. */
    DECELERATION
  }

  static Cause certain(Kind kind) {
    return new Cause(kind, true, Double.NaN, Optional.empty());
  }

  static Cause of(Kind kind, boolean certain, double value) {
    return new Cause(kind, certain, value, Optional.empty());
  }
}
