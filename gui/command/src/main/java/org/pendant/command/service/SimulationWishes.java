package org.pendant.command.service;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;

/**
 * Simulation wishes: what the user of a desktop says of the arm and its simulation; each is empty
 * for as last time.
 *
 * @param arm which arm there is, whatever installations say
 * @param calibration the file that says how the arm differs from its model, in place of that of the
 *     installation
 * @param measuredNoise whether sensors err as on recorded arms
 * @param startRamp whether programs have a start ramp
 * @param scene the file that says what is around the arm, in place of that of last time
 * @param devices kinds of devices that are in the cell, besides those of the scene
 */
public record SimulationWishes(
    Optional<ArmDescription> arm,
    Optional<Path> calibration,
    Optional<Boolean> measuredNoise,
    Optional<Boolean> startRamp,
    Optional<Path> scene,
    List<String> devices) {
  /** As last time. */
  public static final SimulationWishes NONE =
      new SimulationWishes(
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          List.of());

  /** Copies the list. */
  public SimulationWishes {
    devices = List.copyOf(devices);
  }
}
