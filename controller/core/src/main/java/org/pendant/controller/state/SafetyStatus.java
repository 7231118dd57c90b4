package org.pendant.controller.state;

import java.util.Optional;
import org.pendant.controller.box.BaseLight;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyStop;

/**
 * Safety status: power, modes and stops.
 *
 * @param robotMode power and brakes
 * @param safetyMode what the safety functions do
 * @param stop why the arm may not move, while that is so
 * @param stopPlace where program and arm were when the stop began
 * @param reduced whether the reduced limits hold
 * @param baseLight the light ring in the base
 * @param shutDown whether a program has switched the controller off
 * @param checksum of the limits and planes that hold
 */
public record SafetyStatus(
    RobotMode robotMode,
    SafetyMode safetyMode,
    Optional<SafetyStop> stop,
    Optional<StopPlace> stopPlace,
    boolean reduced,
    BaseLight baseLight,
    boolean shutDown,
    SafetyChecksum checksum) {

  /**
   * The status of this frame.
   *
   * @param stopPlace where program and arm were when the stop began
   */
  public static SafetyStatus of(ControlBox box, Optional<StopPlace> stopPlace) {
    return new SafetyStatus(
        box.safety().robotMode(),
        box.safety().safetyMode(),
        box.safety().stop(),
        stopPlace,
        box.safety().reduced(),
        box.arm().baseLight(),
        box.safety().isShutDown(),
        box.safety().checksum());
  }

  /** Whether the status of this frame is this one again. */
  public boolean holdsFor(ControlBox box, Optional<StopPlace> place) {
    return robotMode == box.safety().robotMode()
        && safetyMode == box.safety().safetyMode()
        && stop.equals(box.safety().stop())
        && stopPlace.equals(place)
        && reduced == box.safety().reduced()
        && baseLight.equals(box.arm().baseLight())
        && shutDown == box.safety().isShutDown()
        && checksum.equals(box.safety().checksum());
  }
}
