package org.pendant.script.coverage;

import java.util.List;
import org.pendant.language.source.Source;

/**
 * Coverage map: the places of a program that its runs can reach.
 *
 * @param source the text
 * @param sites in the order of the text
 * @param slots how many marks a run has
 */
public record CoverageMap(Source source, List<CoverageSite> sites, int slots) {
  public CoverageMap {
    sites = List.copyOf(sites);
  }
}
