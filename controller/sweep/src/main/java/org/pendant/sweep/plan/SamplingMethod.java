package org.pendant.sweep.plan;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** Sampling method: how the variants of a plan are chosen. */
public enum SamplingMethod {
  /** Every combination; the last parameter changes first. */
  GRID,
  /** The first values of all parameters, then the second of all. */
  LIST,
  /** Each value at random, from the seed. */
  RANDOM,
  /** At random, but every parameter has one value in each of as many slices as there are runs. */
  LATIN_HYPERCUBE,
  /** Points of a Sobol sequence, which fill the space evenly however many there are. */
  SOBOL,
  /** Those that a search asks for. */
  SEARCH;

  /** As plans write it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Whether the plan says how many runs there are. */
  public boolean counted() {
    return this != GRID && this != LIST;
  }

  static Optional<SamplingMethod> of(String word) {
    return Arrays.stream(values())
        .filter(each -> each != SEARCH && each.word().equals(word))
        .findFirst();
  }

  static List<String> words() {
    return Arrays.stream(values())
        .filter(each -> each != SEARCH)
        .map(SamplingMethod::word)
        .toList();
  }
}
