package org.pendant.controller.freedrive;

import java.util.Optional;

/**
 * Freedrive state: whether and how the arm is guided by hand.
 *
 * @param mode how; empty while it is not guided
 * @param distance how near a singularity is, guided or not
 */
public record FreedriveState(Optional<FreedriveMode> mode, SingularityDistance distance) {

  /** Whether the arm is guided. */
  public boolean active() {
    return mode.isPresent();
  }

  /** Whether it is guided, and this one asked for it. */
  public boolean heldBy(FreedriveHolder holder) {
    return mode.isPresent() && mode.get().holder() == holder;
  }
}
