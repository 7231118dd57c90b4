package org.pendant.controller.rtde;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.controller.io.SignalWrite;
import org.pendant.models.pose.Wrench;

/**
 * Input update: what one package of an RTDE client asks for; all of it comes into force in one
 * frame.
 *
 * @param recipe which inputs the package has, those included that its masks leave as they are
 * @param speedFraction where the speed slider goes, 0 to 1
 * @param externalWrench what an external force/torque sensor reads, N and Nm along the axes of the
 *     flange
 * @param ignored values that cannot be, each with what was expected
 */
public record InputUpdate(
    InputRecipe recipe,
    List<SignalWrite> writes,
    OptionalDouble speedFraction,
    Optional<Wrench> externalWrench,
    List<String> ignored) {
  /** Copies the lists. */
  public InputUpdate {
    writes = List.copyOf(writes);
    ignored = List.copyOf(ignored);
  }
}
