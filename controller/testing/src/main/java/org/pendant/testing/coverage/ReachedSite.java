package org.pendant.testing.coverage;

import java.util.BitSet;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageSite;

/** Reached site: a place of a file, and the numbers of the tests that reach it. */
final class ReachedSite {
  private final int line;
  private final String text;
  private final BitSet reached = new BitSet();
  private final BitSet whenFalse = new BitSet();
  private final BitSet whenTrue = new BitSet();

  ReachedSite(int line, String text) {
    this.line = line;
    this.text = text;
  }

  /** Test {@code number} came to {@code site} of a text, which is this place. */
  void reach(CoverageSite site, Coverage coverage, int number) {
    reached.set(number);
    if (site.kind().twoWay()) {
      if (coverage.reached(site, false)) {
        whenFalse.set(number);
      }
      if (coverage.reached(site, true)) {
        whenTrue.set(number);
      }
    }
  }

  int line() {
    return line;
  }

  BitSet reached() {
    return reached;
  }

  FunctionCoverage function(TestNames names) {
    return new FunctionCoverage(text, line, names.of(reached));
  }

  DecisionCoverage decision() {
    return new DecisionCoverage(line, text, whenFalse.cardinality(), whenTrue.cardinality());
  }
}
