package org.pendant.testing.coverage;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.coverage.CoverageMap;
import org.pendant.script.coverage.CoverageSite;

/**
 * Coverage collector: puts together what the runs of all tests have reached, by files and lines, so
 * that a file counts once in however many texts it was compiled. Any thread may add.
 */
public final class CoverageCollector {
  /** The places of a text in the files; empty for those that are not reported. */
  private record Placed(List<Optional<ReachedSite>> sites, Optional<ReachedNodes.OfScript> nodes) {}

  private final SortedMap<String, FileSites> files = new TreeMap<>();
  private final SortedMap<String, ReachedNodes> trees = new TreeMap<>();

  /** By identity: tests share a program, and to compare texts would take longer. */
  private final IdentityHashMap<CoverageMap, Placed> placed = new IdentityHashMap<>();

  private final Map<String, Integer> numbers = new HashMap<>();
  private final List<String> tests = new ArrayList<>();

  /** A test that ran, whether or not it reaches anything. */
  public synchronized void add(String test) {
    number(test);
  }

  /** A program that is reported even if no test runs it. */
  public synchronized void include(CoverageMap map, LineOrigin origin) {
    placed.computeIfAbsent(map, _ -> place(map, origin));
  }

  /**
   * What a run has reached.
   *
   * @param test its name; several runs may belong to one test
   * @param origin where the lines of its text come from; of a text that was added before, the
   *     origin of that time counts
   */
  public synchronized void add(String test, Coverage coverage, LineOrigin origin) {
    CoverageMap map = coverage.map();
    Placed places = placed.computeIfAbsent(map, _ -> place(map, origin));
    int number = number(test);
    for (int i = 0; i < map.sites().size(); i++) {
      CoverageSite site = map.sites().get(i);
      if (coverage.reached(site)) {
        places.sites().get(i).ifPresent(each -> each.reach(site, coverage, number));
        places.nodes().ifPresent(each -> each.reach(site, number));
      }
    }
  }

  private int number(String test) {
    return numbers.computeIfAbsent(
        test,
        _ -> {
          tests.add(test);
          return tests.size() - 1;
        });
  }

  private Placed place(CoverageMap map, LineOrigin origin) {
    Source source = map.source();
    Map<String, Integer> ordinals = new HashMap<>();
    List<Optional<ReachedSite>> sites = new ArrayList<>();
    for (CoverageSite site : map.sites()) {
      sites.add(
          origin
              .of(site.line())
              .map(
                  at -> {
                    int ordinal =
                        ordinals.merge(
                            site.kind() + ":" + at.line() + ":" + at.file(), 1, Integer::sum);
                    return file(at.file())
                        .site(at.line(), site.kind(), ordinal, name(site, source));
                  }));
    }
    if (origin instanceof TreeOrigin tree) {
      file(tree.file()).text(tree.text());
      ReachedNodes nodes = trees.computeIfAbsent(tree.file(), _ -> new ReachedNodes());
      return new Placed(sites, Optional.of(nodes.of(tree, map)));
    }
    boolean ended = source.text().endsWith("\n");
    for (int line = 1; line <= source.lineCount() - (ended ? 1 : 0); line++) {
      int each = line;
      origin
          .of(line)
          .ifPresent(
              at -> file(at.file()).text(at.line(), ByteText.decoded(source.lineText(each))));
    }
    return new Placed(sites, Optional.empty());
  }

  private static String name(CoverageSite site, Source source) {
    return ByteText.decoded(source.text(site.range()));
  }

  private FileSites file(String name) {
    return files.computeIfAbsent(name, _ -> new FileSites());
  }

  /** The report of all that was added. */
  public synchronized CoverageReport report() {
    Map<BitSet, List<String>> named = new HashMap<>();
    TestNames names = set -> named.computeIfAbsent(set, each -> sorted((BitSet) each.clone()));
    List<FileCoverage> all = new ArrayList<>();
    files.forEach((file, sites) -> sites.coverage(file, names).ifPresent(all::add));
    List<TreeCoverage> ofTrees = new ArrayList<>();
    trees.forEach((file, nodes) -> ofTrees.add(nodes.coverage(file, names)));
    return new CoverageReport(tests.stream().sorted().toList(), all, ofTrees);
  }

  private List<String> sorted(BitSet numbersOfTests) {
    return numbersOfTests.stream().mapToObj(tests::get).sorted().toList();
  }
}
