package org.pendant.testing.run;

import java.util.Optional;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestStatus;

/**
 * Test outcome: the verdict on one run.
 *
 * @param skipped why it counts as skipped; empty text where it does not
 * @param failure why it is red; present exactly then
 */
record TestOutcome(TestStatus status, String skipped, Optional<TestFailure> failure) {
  static final TestOutcome PASSED = new TestOutcome(TestStatus.PASSED, "", Optional.empty());

  /** People have ended the run before there was a verdict. */
  static final TestOutcome STOPPED = skipped("stopped");

  static TestOutcome skipped(String reason) {
    return new TestOutcome(TestStatus.SKIPPED, reason, Optional.empty());
  }

  static TestOutcome red(TestStatus status, TestFailure failure) {
    return new TestOutcome(status, "", Optional.of(failure));
  }
}
