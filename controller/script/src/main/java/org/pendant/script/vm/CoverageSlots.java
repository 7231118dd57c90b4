package org.pendant.script.vm;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.coverage.CoverageSite;

/** Coverage slots: gives each place of a program its marks while that is compiled. */
final class CoverageSlots {
  private final List<CoverageSite> sites = new ArrayList<>();
  private int next;

  /** Pairs: a mark that is not made, and the later one that stands for it. */
  private final List<int[]> implied = new ArrayList<>();

  /** The first of {@code count} marks that are not taken yet. */
  int take(int count) {
    int first = next;
    next += count;
    return first;
  }

  void add(CoverageSite site) {
    sites.add(site);
  }

  /** Who reaches {@code later} has reached {@code slot}, which is not marked. */
  void imply(int slot, int later) {
    implied.add(new int[] {slot, later});
  }

  /** Adds what {@code marks} imply to them. */
  void complete(byte[] marks) {
    // a statement that stands for one before may have one that stands for it, which came later
    for (int[] pair : implied.reversed()) {
      marks[pair[0]] |= marks[pair[1]];
    }
  }

  CoverageMap map(Source source) {
    sites.sort(
        Comparator.comparingInt((CoverageSite site) -> site.range().start())
            .thenComparing(CoverageSite::kind)
            .thenComparing(site -> site.range().end(), Comparator.reverseOrder()));
    return new CoverageMap(source, sites, next);
  }
}
