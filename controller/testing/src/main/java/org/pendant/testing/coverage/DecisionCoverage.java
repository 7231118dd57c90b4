package org.pendant.testing.coverage;

/**
 * Decision coverage: the condition of an {@code if}, {@code elif} or {@code while}, or an operand
 * of {@code and} or {@code or}.
 *
 * @param line where it begins, 1-based
 * @param text of it
 * @param whenFalse in how many tests it was False
 * @param whenTrue in how many tests it was True
 */
public record DecisionCoverage(int line, String text, int whenFalse, int whenTrue) {
  /** Its two ways. */
  public Share ways() {
    return new Share((whenFalse > 0 ? 1 : 0) + (whenTrue > 0 ? 1 : 0), 2);
  }

  /** What it lacks, such as {@code never true}; empty if nothing. */
  public String missing() {
    if (whenFalse > 0) {
      return whenTrue > 0 ? "" : CoverageTexts.text("neverTrue");
    }
    return CoverageTexts.text(whenTrue > 0 ? "neverFalse" : "neverReached");
  }
}
