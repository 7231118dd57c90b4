package org.pendant.testing.coverage;

import java.util.List;

/**
 * Function coverage: a function or thread.
 *
 * @param line of its name, 1-based
 * @param tests in which it was called or started, sorted
 */
public record FunctionCoverage(String name, int line, List<String> tests) {
  public FunctionCoverage {
    tests = List.copyOf(tests);
  }

  /** Whether it was called or started. */
  public boolean reached() {
    return !tests.isEmpty();
  }
}
