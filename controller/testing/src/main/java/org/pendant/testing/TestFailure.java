package org.pendant.testing;

import java.util.List;
import java.util.Optional;

/**
 * Test failure: why a test is red.
 *
 * @param code stable kebab-case identifier, such as {@code assertion-failed}
 * @param message what was found and what was expected, for people
 * @param place where; empty where no line is to blame
 * @param stack where that was called from, innermost first; without {@code place}
 */
public record TestFailure(
    String code, String message, Optional<TestPlace> place, List<TestPlace> stack) {
  public TestFailure {
    stack = List.copyOf(stack);
  }
}
