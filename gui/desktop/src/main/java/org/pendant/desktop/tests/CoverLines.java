package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.pendant.desktop.editor.LineCover;
import org.pendant.desktop.editor.LineCover.Reach;
import org.pendant.kit.text.Messages;
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
    missing.forEach(
        (line, lacks) -> all.put(line, cover(Reach.SOME, text("inPart"), lacks, List.of())));
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
        .add(Messages.told(decision.text(), decision.missing()));
  }

  private LineCover cover(FunctionCoverage function) {
    return function.reached()
        ? cover(
            Reach.ALL,
            text("isCalledBy", function.name(), count(function.tests().size())),
            List.of(),
            function.tests())
        : cover(Reach.NONE, text("isNeverCalled", function.name()), List.of(), List.of());
  }

  private LineCover cover(LineCoverage line) {
    if (!line.reached()) {
      return cover(Reach.NONE, text("noTestReachesThisLine"), List.of(), List.of());
    }
    List<String> lacks = new ArrayList<>(missing.getOrDefault(line.line(), List.of()));
    int left = line.statements().total() - line.statements().reached();
    if (left > 0) {
      lacks.add(text("statementsNotReached", left, line.statements().total()));
    }
    return cover(
        lacks.isEmpty() ? Reach.ALL : Reach.SOME,
        text("reachedBy", count(line.tests().size())),
        lacks,
        line.tests());
  }

  private String count(int number) {
    return text(tests == 1 ? "ofOneTest" : "ofTests", number, tests);
  }

  private static LineCover cover(
      Reach reach, String about, List<String> lacks, List<String> names) {
    List<String> whole = new ArrayList<>();
    whole.add(about);
    whole.addAll(lacks);
    names.stream().limit(MAX_NAMED).forEach(each -> whole.add("\u2022 " + each));
    if (names.size() > MAX_NAMED) {
      whole.add(text("andSoManyMore", names.size() - MAX_NAMED));
    }
    String line = lacks.isEmpty() ? about : about + "; " + String.join("; ", lacks);
    return new LineCover(reach, false, line, String.join("\n", whole));
  }
}
