package org.pendant.bench;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.pendant.language.source.Source;

/**
 * How much coverage slows programs down: each runs with and without it in turn, and CPU time of the
 * thread is compared, the least and the median of all rounds.
 */
final class CoverageCost {
  /** Programs that compute, and one that moves the arm for a minute of robot time. */
  private static final List<String> TASKS =
      List.of("fib", "loops", "strings", "matrix", "poses", "minute");

  private static final int WARM_UP = 3;
  private static final double NS_A_MS = 1e6;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final int rounds;

  private CoverageCost(int rounds) {
    this.rounds = rounds;
  }

  /**
   * Prints a table.
   *
   * @param arguments how many rounds, 15 without it; and which tasks, with commas between
   */
  public static void main(String[] arguments) {
    CoverageCost cost =
        new CoverageCost(arguments.length > 0 ? Integer.parseInt(arguments[0]) : 15);
    System.out.println("| task | without | with | | median without | with | |");
    System.out.println("| --- | ---: | ---: | ---: | ---: | ---: | ---: |");
    for (String task : arguments.length > 1 ? List.of(arguments[1].split(",")) : TASKS) {
      System.out.println(cost.row(task));
    }
  }

  private String row(String task) {
    Source source = BenchmarkScript.source(task);
    BenchmarkScript without = BenchmarkScript.load(source);
    BenchmarkScript with = BenchmarkScript.loadCovered(source);
    long[] plain = new long[rounds];
    long[] covered = new long[rounds];
    for (int round = -WARM_UP; round < rounds; round++) {
      long plainNs = run(without);
      long coveredNs = run(with);
      if (round >= 0) {
        plain[round] = plainNs;
        covered[round] = coveredNs;
      }
    }
    Arrays.sort(plain);
    Arrays.sort(covered);
    return String.join(
            " | ",
            "| " + task,
            both(plain[0], covered[0]),
            both(plain[rounds / 2], covered[rounds / 2]))
        + " |";
  }

  private static String both(long without, long with) {
    return String.format(
        Locale.ROOT,
        "%.2f | %.2f | %+.1f %%",
        without / NS_A_MS,
        with / NS_A_MS,
        100.0 * (with - without) / without);
  }

  /** One run, in nanoseconds. */
  private long run(BenchmarkScript script) {
    long start = threads.getCurrentThreadCpuTime();
    script.runToEnd();
    return threads.getCurrentThreadCpuTime() - start;
  }
}
