package org.pendant.testing.mutation;

import java.util.List;
import org.pendant.language.source.Source;

/**
 * Mutated file: one program under test, and its mutants.
 *
 * @param mutants in the order of the text
 */
public record MutatedFile(Source source, List<Mutant> mutants) {
  public MutatedFile {
    mutants = List.copyOf(mutants);
  }

  /** How many mutants have that status. */
  public long count(MutantStatus status) {
    return mutants.stream().filter(each -> each.status() == status).count();
  }

  /** Its score. */
  public MutationScore score() {
    return MutationScore.of(this);
  }
}
