package org.pendant.controller.freedrive;

import java.util.Optional;
import org.pendant.models.arm.DhLengths;
import org.pendant.models.arm.Joints;

/**
 * Freedrive state: whether and how the arm is guided by hand.
 *
 * @param mode how; empty while it is not guided
 * @param distance how near a singularity is, guided or not
 */
public record FreedriveState(Optional<FreedriveMode> mode, SingularityDistance distance) {

  /** The state of an arm with these lengths, guided so and at these joint positions, rad. */
  public static FreedriveState at(DhLengths dh, Optional<FreedriveMode> mode, Joints positionRad) {
    return new FreedriveState(mode, SingularityDistance.at(dh, positionRad));
  }

  /** Whether the arm is guided. */
  public boolean active() {
    return mode.isPresent();
  }

  /** Whether it is guided, and this one asked for it. */
  public boolean heldBy(FreedriveHolder holder) {
    return mode.isPresent() && mode.get().holder() == holder;
  }
}
