package org.pendant.testing;

/** Test status: what came of one test. */
public enum TestStatus {
  /** It ran to its end and every expectation held. */
  PASSED,
  /** An expectation did not hold. */
  FAILED,
  /** Something else ended it: a runtime error, a safety stop, a file that cannot be read. */
  ERROR,
  /** It ran longer than it may, in robot time or on the wall clock. */
  TIMED_OUT,
  /** It was not run, and says why. */
  SKIPPED;

  /** Whether the suite is red with it. */
  public boolean red() {
    return this == FAILED || this == ERROR || this == TIMED_OUT;
  }
}
