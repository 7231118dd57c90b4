package org.pendant.testing.coverage;

import java.util.List;

/**
 * Line coverage: a line on which statements begin.
 *
 * @param line 1-based
 * @param statements that begin on it, and how many were reached
 * @param tests that reached one of them, sorted
 */
public record LineCoverage(int line, Share statements, List<String> tests) {
  public LineCoverage {
    tests = List.copyOf(tests);
  }

  /** Whether a statement on it was reached. */
  public boolean reached() {
    return statements.reached() > 0;
  }
}
