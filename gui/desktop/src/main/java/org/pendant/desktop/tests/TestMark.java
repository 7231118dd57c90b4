package org.pendant.desktop.tests;

import org.pendant.testing.TestStatus;

/** Test mark: what the tree says of a test, or of all tests of a file together. */
enum TestMark {
  /** It has not run yet. */
  NEW,
  /** It is going to run, or runs now. */
  WAITING,
  /** It held. */
  PASSED,
  /** It did not. */
  RED,
  /** It was not run, and says why. */
  SKIPPED;

  static TestMark of(TestStatus status) {
    return switch (status) {
      case PASSED -> PASSED;
      case FAILED, ERROR, TIMED_OUT -> RED;
      case SKIPPED -> SKIPPED;
    };
  }
}
