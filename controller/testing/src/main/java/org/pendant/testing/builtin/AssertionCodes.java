package org.pendant.testing.builtin;

/** Codes of the script errors by which tests say how they end. */
public final class AssertionCodes {
  /** An expectation does not hold. */
  public static final String FAILED = "assertion-failed";

  /** The test does not want to be run. */
  public static final String SKIPPED = "test-skipped";

  /** This run of a test does not count. */
  public static final String DROPPED = "run-dropped";

  private AssertionCodes() {}
}
