package org.pendant.sweep.plan;

/**
 * Sampling: which variants a plan has.
 *
 * @param method how they are chosen
 * @param runs how many; what the parameters make of it for a grid and a list, and the most for a
 *     search
 * @param seed of what is chosen at random
 */
public record Sampling(SamplingMethod method, long runs, long seed) {
  /** More runs than that are a slip. */
  public static final long MAX_RUNS = 1_000_000_000;
}
