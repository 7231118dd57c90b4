package org.pendant.command.service;

import java.util.Optional;

/**
 * Simulation wishes: what the user of a desktop says of the arm's simulation; each is empty for as
 * last time.
 *
 * @param measuredNoise whether sensors err as on recorded arms
 * @param startRamp whether programs have a start ramp
 */
public record SimulationWishes(Optional<Boolean> measuredNoise, Optional<Boolean> startRamp) {
  /** As last time. */
  public static final SimulationWishes NONE =
      new SimulationWishes(Optional.empty(), Optional.empty());
}
