package org.pendant.motion;

/**
 * Planning exception: a motion cannot be planned. Carries the failure to the caller that asked for
 * the motion, and no Java stack trace: it describes what was asked for, not this code.
 */
public final class PlanningException extends Exception {
  private static final long serialVersionUID = 1L;
  private final String code;

  public PlanningException(MotionFailure failure) {
    this(failure.code(), failure.message());
  }

  /**
   * @param code stable kebab-case identifier, e.g. {@code out-of-reach}
   * @param message what, the value, what was expected
   */
  public PlanningException(String code, String message) {
    super(message, null, false, false);
    this.code = code;
  }

  /** Stable kebab-case identifier of the failure, e.g. {@code out-of-reach}. */
  public String code() {
    return code;
  }

  /** Why there is no such motion. */
  public MotionFailure failure() {
    return new MotionFailure(code, getMessage());
  }
}
