package org.pendant.script.coverage;

import java.util.BitSet;

/** Coverage of one run: which places of its program it has reached. Immutable. */
public final class Coverage {
  private final CoverageMap map;
  private final BitSet reached = new BitSet();

  /**
   * Coverage that the marks of a run tell.
   *
   * @param marks one for each slot of {@code map}, not 0 where the run was
   */
  public Coverage(CoverageMap map, byte[] marks) {
    this.map = map;
    for (int slot = 0; slot < marks.length; slot++) {
      reached.set(slot, marks[slot] != 0);
    }
  }

  /** The places that could be reached. */
  public CoverageMap map() {
    return map;
  }

  /** Whether the run came to {@code site}: one of the map; for one with two ways, by either. */
  public boolean reached(CoverageSite site) {
    return reached.get(site.slot()) || (site.kind().twoWay() && reached.get(site.slot() + 1));
  }

  /** Whether {@code site}, one of the map that has two ways, was ever {@code truth}. */
  public boolean reached(CoverageSite site, boolean truth) {
    return reached.get(site.slot() + (truth ? 1 : 0));
  }
}
