package org.pendant.testing.coverage.report;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.DecisionCoverage;
import org.pendant.testing.coverage.FileCoverage;
import org.pendant.testing.coverage.FunctionCoverage;
import org.pendant.testing.coverage.LineCoverage;
import org.pendant.testing.coverage.Share;

/**
 * Lcov coverage: coverage as a tracefile of lcov, by the section FILES of {@code geninfo(1)}. What
 * others count as executions are tests that reach a place. Branch 0 of a condition is the way for
 * True, branch 1 that for False.
 */
public final class LcovCoverage {
  private LcovCoverage() {}

  /** The tracefile; lines end with a line feed. */
  public static String of(CoverageReport report) {
    return report.files().stream()
        .map(LcovCoverage::file)
        .flatMap(List::stream)
        .map(line -> line + "\n")
        .collect(Collectors.joining());
  }

  private static List<String> file(FileCoverage file) {
    List<String> lines = new ArrayList<>(List.of("TN:", "SF:" + file.file()));
    functions(file, lines);
    branches(file, lines);
    for (LineCoverage line : file.lines()) {
      lines.add("DA:" + line.line() + "," + line.tests().size());
    }
    summary("LF", "LH", file.reachedLines(), lines);
    lines.add("end_of_record");
    return lines;
  }

  private static void functions(FileCoverage file, List<String> lines) {
    Map<String, Long> uses =
        file.functions().stream()
            .collect(Collectors.groupingBy(FunctionCoverage::name, Collectors.counting()));
    // lcov knows functions of a file by their names alone
    Function<FunctionCoverage, String> name =
        function ->
            uses.get(function.name()) > 1
                ? function.name() + ":" + function.line()
                : function.name();
    file.functions().forEach(each -> lines.add("FN:" + each.line() + "," + name.apply(each)));
    file.functions()
        .forEach(each -> lines.add("FNDA:" + each.tests().size() + "," + name.apply(each)));
    summary("FNF", "FNH", file.calledFunctions(), lines);
  }

  private static void branches(FileCoverage file, List<String> lines) {
    Map<Integer, Integer> blocks = new HashMap<>();
    for (DecisionCoverage branch : file.branches()) {
      int block = blocks.merge(branch.line(), 1, Integer::sum) - 1;
      String begin = "BRDA:" + branch.line() + "," + block + ",";
      boolean reached = branch.ways().reached() > 0;
      lines.add(begin + "0," + (reached ? branch.whenTrue() : "-"));
      lines.add(begin + "1," + (reached ? branch.whenFalse() : "-"));
    }
    summary("BRF", "BRH", file.branchWays(), lines);
  }

  private static void summary(String found, String hit, Share share, List<String> lines) {
    lines.add(found + ":" + share.total());
    lines.add(hit + ":" + share.reached());
  }
}
