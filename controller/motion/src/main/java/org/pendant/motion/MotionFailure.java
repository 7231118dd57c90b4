package org.pendant.motion;

/**
 * Motion failure: why a motion cannot continue; the arm stops beside its path.
 *
 * @param code stable kebab-case identifier
 * @param message what, the value, what was expected
 */
public record MotionFailure(String code, String message) {
  /** There are no joint positions for a point of the path. */
  public static final String OUT_OF_REACH = "out-of-reach";

  /** The path leads to where joints would have to turn without bounds. */
  public static final String SINGULARITY = "singularity";

  /** A joint is at the end of its range where the path would turn it on. */
  public static final String RANGE_ENDS = "joint-out-of-range";

  /** A joint would have to turn faster than it can. */
  public static final String TOO_FAST = "joint-speed";

  /** Whether a code says that a path cannot be followed, rather than that there is none. */
  static boolean isOfPath(String code) {
    return switch (code) {
      case OUT_OF_REACH, SINGULARITY, RANGE_ENDS, TOO_FAST -> true;
      default -> false;
    };
  }
}
