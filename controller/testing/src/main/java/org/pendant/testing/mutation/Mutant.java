package org.pendant.testing.mutation;

import java.util.List;
import java.util.Optional;
import org.pendant.testing.TestId;

/**
 * Mutant: a program with one mutation in it, and what came of that.
 *
 * @param covering the tests that reach it, those that run shortest first
 * @param killer the test that was red
 * @param reason what that test said, or why it is no program
 */
public record Mutant(
    Mutation mutation,
    MutantStatus status,
    List<TestId> covering,
    Optional<TestId> killer,
    String reason) {
  public Mutant {
    covering = List.copyOf(covering);
  }
}
