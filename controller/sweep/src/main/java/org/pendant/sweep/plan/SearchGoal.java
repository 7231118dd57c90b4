package org.pendant.sweep.plan;

import java.util.List;

/**
 * Search goal: what the values of a plan's parameters are searched for, rather than sampled.
 *
 * @param column of the results that is to be as small as possible, or as large
 * @param maximize whether large is good
 * @param limits what must hold of a run, such as {@code torque_share <= 0.8}
 * @param population runs in each generation, 4 or more
 * @param stall generations without a better run after which the search ends
 */
public record SearchGoal(
    String column, boolean maximize, List<String> limits, int population, int stall) {
  /** Runs that there are at most, where the plan does not say. */
  public static final long STANDARD_RUNS = 400;

  /** Generations without a better run, where the plan does not say. */
  public static final int STANDARD_STALL = 15;

  private static final int MIN_STANDARD = 8;

  /** Copies the list. */
  public SearchGoal {
    limits = List.copyOf(limits);
  }

  /** Runs in each generation, where the plan does not say. */
  public static int standardPopulation(int parameters) {
    // what Hansen recommends, but enough for the cores of a machine
    return Math.max(MIN_STANDARD, 4 + (int) (3 * Math.log(Math.max(1, parameters))));
  }
}
