package org.pendant.testing.mutation;

import java.util.List;

/**
 * Mutation settings: which mutants are tried.
 *
 * @param only parts of names, of which a program's own has one; empty for all programs
 * @param most how many mutants are tried at most; 0 for all
 * @param seed of the choice where there are more
 * @param jobs how many are tried at once, 1 or more
 */
public record MutationSettings(List<String> only, int most, long seed, int jobs) {
  /** How many mutants are tried where nobody says otherwise. */
  public static final int STANDARD_MOST = 200;

  public MutationSettings {
    only = List.copyOf(only);
  }
}
