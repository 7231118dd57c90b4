package org.pendant.testing.coverage;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.pendant.script.coverage.CoverageSite.Kind;

/** File sites: all places of one file. */
final class FileSites {
  /**
   * Which place of its kind it is.
   *
   * @param ordinal of those on the line, from 1
   */
  private record Key(int line, int ordinal) implements Comparable<Key> {
    private static final Comparator<Key> ORDER =
        Comparator.comparingInt(Key::line).thenComparingInt(Key::ordinal);

    @Override
    public int compareTo(Key other) {
      return ORDER.compare(this, other);
    }
  }

  private final Map<Kind, SortedMap<Key, ReachedSite>> sites = new EnumMap<>(Kind.class);
  private final SortedMap<Integer, String> text = new TreeMap<>();

  /** The place that is the {@code ordinal}th of its kind on a line. */
  ReachedSite site(int line, Kind kind, int ordinal, String name) {
    return sites
        .computeIfAbsent(kind, _ -> new TreeMap<>())
        .computeIfAbsent(new Key(line, ordinal), _ -> new ReachedSite(line, name));
  }

  void text(int line, String content) {
    text.putIfAbsent(line, content);
  }

  void text(List<String> lines) {
    for (int i = 0; i < lines.size(); i++) {
      text(i + 1, lines.get(i));
    }
  }

  /** The coverage of the file; empty for one without any place. */
  Optional<FileCoverage> coverage(String file, TestNames names) {
    if (sites.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        new FileCoverage(
            file,
            lines(),
            statements(names),
            of(Kind.FUNCTION).stream().map(site -> site.function(names)).toList(),
            of(Kind.BRANCH).stream().map(ReachedSite::decision).toList(),
            of(Kind.CONDITION).stream().map(ReachedSite::decision).toList()));
  }

  private List<ReachedSite> of(Kind kind) {
    return List.copyOf(sites.getOrDefault(kind, new TreeMap<>()).values());
  }

  private List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (int line = 1; !text.isEmpty() && line <= text.lastKey(); line++) {
      lines.add(text.getOrDefault(line, ""));
    }
    return lines;
  }

  private List<LineCoverage> statements(TestNames names) {
    SortedMap<Integer, List<ReachedSite>> byLine = new TreeMap<>();
    of(Kind.STATEMENT)
        .forEach(site -> byLine.computeIfAbsent(site.line(), _ -> new ArrayList<>()).add(site));
    List<LineCoverage> lines = new ArrayList<>();
    byLine.forEach(
        (line, statements) -> {
          BitSet tests = new BitSet();
          statements.forEach(site -> tests.or(site.reached()));
          Share share =
              Share.of(statements, site -> new Share(site.reached().isEmpty() ? 0 : 1, 1));
          lines.add(new LineCoverage(line, share, names.of(tests)));
        });
    return lines;
  }
}
