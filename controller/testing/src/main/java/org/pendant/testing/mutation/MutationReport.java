package org.pendant.testing.mutation;

import java.util.List;

/**
 * Mutation report: what came of all mutants. The same tests and programs, and the same seed, give
 * an equal report, however many ran at once.
 *
 * @param files that were mutated, in the order of their names
 * @param places how many mutations there would be, those that were not chosen included
 * @param notRun how many were chosen and not tried, since the run was interrupted
 */
public record MutationReport(List<MutatedFile> files, int places, int notRun) {
  public MutationReport {
    files = List.copyOf(files);
  }

  /** The score of all files. */
  public MutationScore score() {
    return files.stream().map(MutatedFile::score).reduce(MutationScore.NONE, MutationScore::plus);
  }

  /** How many mutants there are, those that are no programs included. */
  public int mutants() {
    return files.stream().mapToInt(file -> file.mutants().size()).sum();
  }
}
