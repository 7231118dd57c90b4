package org.pendant.desktop.tests;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.pendant.desktop.editor.LineCover;
import org.pendant.desktop.editor.LineCover.Reach;
import org.pendant.testing.coverage.DecisionCoverage;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.FunctionCoverage;
import org.pendant.testing.coverage.LineCoverage;

/** Cover lines: what stands beside the lines of a file, from what tests have reached of it. */
final class CoverLines {
  /** More tests than this are only counted where they are named. */
  private static final int MAX_NAMED = 12;

  private final int tests;
  private final Map<Integer, List<String>> missing = new HashMap<>();
  private final Map<Integer, LineCover> all = new TreeMap<>();

  private CoverLines(FileCoverage file, int tests) {
    this.tests = tests;
    Map<Integer, LineCoverage> lines = new HashMap<>();
    file.lines().forEach(line -> lines.put(line.line(), line));
    Stream.concat(file.branches().stream(), file.conditions().stream())
        .filter(each -> !each.missing().isEmpty())
        .filter(each -> !lines.containsKey(each.line()) || lines.get(each.line()).reached())
        .forEach(this::lack);
    file.functions().forEach(each -> all.put(each.line(), cover(each)));
    missing.forEach((line, lacks) -> all.put(line, cover(Reach.SOME, "In part", lacks, List.of())));
    lines.values().forEach(each -> all.put(each.line(), cover(each)));
  }

  /**
   * What is known, by lines from 1.
   *
   * @param tests how many ran
   */
  static Map<Integer, LineCover> of(FileCoverage file, int tests) {
    return new CoverLines(file, tests).all;
  }

  private void lack(DecisionCoverage decision) {
    missing
        .computeIfAbsent(decision.line(), _ -> new ArrayList<>())
        .add(decision.text() + ": " + decision.missing());
  }

  private LineCover cover(FunctionCoverage function) {
    return function.reached()
        ? cover(
            Reach.ALL,
            function.name() + " is called by " + count(function.tests().size()),
            List.of(),
            function.tests())
        : cover(Reach.NONE, function.name() + " is never called", List.of(), List.of());
  }

  private LineCover cover(LineCoverage line) {
    if (!line.reached()) {
      return cover(Reach.NONE, "No test reaches this line", List.of(), List.of());
    }
    List<String> lacks = new ArrayList<>(missing.getOrDefault(line.line(), List.of()));
    int left = line.statements().total() - line.statements().reached();
    if (left > 0) {
      lacks.add(
          left + " of " + line.statements().total() + " statements of the line are not reached");
    }
    return cover(
        lacks.isEmpty() ? Reach.ALL : Reach.SOME,
        "Reached by " + count(line.tests().size()),
        lacks,
        line.tests());
  }

  private String count(int number) {
    return number + " of " + tests + (tests == 1 ? " test" : " tests");
  }

  private static LineCover cover(
      Reach reach, String about, List<String> lacks, List<String> names) {
    List<String> whole = new ArrayList<>();
    whole.add(about);
    whole.addAll(lacks);
    names.stream().limit(MAX_NAMED).forEach(each -> whole.add("\u2022 " + each));
    if (names.size() > MAX_NAMED) {
      whole.add("and " + (names.size() - MAX_NAMED) + " more");
    }
    String line = lacks.isEmpty() ? about : about + "; " + String.join("; ", lacks);
    return new LineCover(reach, false, line, String.join("\n", whole));
  }
}
