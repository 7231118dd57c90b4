package org.pendant.controller.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.SplittableRandom;

/**
 * Choices of one run of a test: numbers from 0 up to but without 1 that everything random in it is
 * made from. The same choices give the same run; smaller ones give a simpler one.
 */
public final class Choices {
  /** Most of them that are kept, and so repeated; more of a run are random. */
  public static final int MAX_KEPT = 1000;

  private static final int MAX_TOLD = 20;

  private final List<Double> given;
  private final Optional<SplittableRandom> random;
  private final List<Double> made = new ArrayList<>();
  private final List<String> told = new ArrayList<>();
  private int next;

  /**
   * Choices.
   *
   * @param given the first ones
   * @param seed of those that follow; empty for the simplest, which are all 0
   */
  public Choices(List<Double> given, OptionalLong seed) {
    this.given = List.copyOf(given);
    random =
        seed.isPresent() ? Optional.of(new SplittableRandom(seed.getAsLong())) : Optional.empty();
  }

  /** The next choice. */
  public double next() {
    double choice =
        next < given.size()
            ? given.get(next)
            : random.map(SplittableRandom::nextDouble).orElse(0.0);
    next++;
    if (made.size() < MAX_KEPT) {
      made.add(choice);
    }
    return choice;
  }

  /** Tells for people what was made of choices. */
  public void tell(String what) {
    if (told.size() < MAX_TOLD) {
      told.add(what);
    }
  }

  /** Those that were made, in order. */
  public List<Double> made() {
    return List.copyOf(made);
  }

  /** What was made of the first of them, for people. */
  public List<String> told() {
    return List.copyOf(told);
  }
}
