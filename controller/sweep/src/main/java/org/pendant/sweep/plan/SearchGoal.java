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
  /** Copies the list. */
  public SearchGoal {
    limits = List.copyOf(limits);
  }
}
