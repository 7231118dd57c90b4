package org.pendant.testing.coverage;

import java.util.List;

/**
 * Node coverage: a node of a program tree.
 *
 * @param number in the tree, from 1
 * @param label as in the tree
 * @param tests that reached it or a node below it, sorted
 */
public record NodeCoverage(int number, String label, List<String> tests) {
  public NodeCoverage {
    tests = List.copyOf(tests);
  }

  /** Whether a test reached it. */
  public boolean reached() {
    return !tests.isEmpty();
  }
}
