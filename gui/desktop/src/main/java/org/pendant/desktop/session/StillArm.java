package org.pendant.desktop.session;

import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;

/**
 * Still arm: shows an arm that rests where it was shown before, as long as it is there but for the
 * noise of its encoders: otherwise everything on the screen that goes by its place would be drawn
 * anew all the time, and look the same.
 */
public final class StillArm {
  /** Nobody sees a joint turn by less, rad. */
  private static final double VISIBLE_RAD = 1e-4;

  private Optional<Joints> shownRad = Optional.empty();

  /** What to show of {@code state}. */
  public ControllerState shown(ControllerState state) {
    Joints readRad = state.arm().actualPositionRad();
    if (state.armRests()
        && shownRad.isPresent()
        && readRad.maxAbsDifference(shownRad.get()) < VISIBLE_RAD) {
      return readRad.equals(shownRad.get()) ? state : state.withActualPosition(shownRad.get());
    }
    shownRad = Optional.of(readRad);
    return state;
  }
}
