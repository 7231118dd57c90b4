package org.pendant.testing.mutation;

import java.util.Locale;

/**
 * Mutation score: how many mutants tests have noticed.
 *
 * @param killed those with which a test was red, or took far too long
 * @param survived those that tests reach without noticing
 * @param notCovered those that no test reaches
 */
public record MutationScore(long killed, long survived, long notCovered) {
  /** Of nothing. */
  public static final MutationScore NONE = new MutationScore(0, 0, 0);

  static MutationScore of(MutatedFile file) {
    return new MutationScore(
        file.count(MutantStatus.KILLED) + file.count(MutantStatus.TIMED_OUT),
        file.count(MutantStatus.SURVIVED),
        file.count(MutantStatus.NOT_COVERED));
  }

  /** That of both. */
  MutationScore plus(MutationScore other) {
    return new MutationScore(
        killed + other.killed, survived + other.survived, notCovered + other.notCovered);
  }

  /** All of them. */
  public long total() {
    return killed + survived + notCovered;
  }

  /** The part that was killed, 0 to 100; 100 of nothing. */
  public double percent() {
    return total() == 0 ? 100 : 100.0 * killed / total();
  }

  /** Such as {@code 83.3 %}: 100 only when all were killed; {@code -} of nothing. */
  public String text() {
    if (total() == 0) {
      return "-";
    }
    double shown = killed == total() ? 100 : Math.min(percent(), 99.9);
    return String.format(Locale.ROOT, "%.1f %%", shown);
  }
}
