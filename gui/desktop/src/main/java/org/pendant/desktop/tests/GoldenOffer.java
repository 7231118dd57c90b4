package org.pendant.desktop.tests;

import java.util.Optional;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestResult;

/** Golden offer: whether the new run of a test can become what it is compared with. */
enum GoldenOffer {
  /** The test is red for another reason, or is not. */
  NONE,
  /** There is no recording yet. */
  RECORD,
  /** It takes the place of one. */
  REPLACE;

  /** What a result offers. */
  static GoldenOffer of(Optional<TestResult> result) {
    return switch (result.flatMap(TestResult::failure).map(TestFailure::code).orElse("")) {
      case "golden-missing" -> RECORD;
      case "golden-differs", "golden-unreadable" -> REPLACE;
      default -> NONE;
    };
  }
}
