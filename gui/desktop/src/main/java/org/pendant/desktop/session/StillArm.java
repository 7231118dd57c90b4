package org.pendant.desktop.session;

import java.util.Optional;
import org.pendant.controller.state.ControllerState;
import org.pendant.models.arm.Joints;

/**
 * Still arm: shows an arm that rests where it was shown before, as long as it is there but for the
 * noise of its encoders: otherwise everything on the screen that goes by its place would be drawn
 * anew all the time, and look the same. An arm that has been told to rest for a while counts as one
 * that rests: with a load that nobody has declared its drives never do.
 */
public final class StillArm {
  /** Nobody sees a joint turn by less, rad. */
  private static final double VISIBLE_RAD = 1e-4;

  /** So often the same target was looked at when the arm has come to it. */
  private static final int SETTLING_LOOKS = 60;

  private Optional<Joints> shownRad = Optional.empty();
  private Optional<Joints> targetRad = Optional.empty();
  private int looks;

  /** What to show of {@code state}. */
  public ControllerState shown(ControllerState state) {
    Joints readRad = state.arm().actualPositionRad();
    if (rests(state)
        && shownRad.isPresent()
        && readRad.maxAbsDifference(shownRad.get()) < VISIBLE_RAD) {
      return readRad.equals(shownRad.get()) ? state : state.withActualPosition(shownRad.get());
    }
    shownRad = Optional.of(readRad);
    return state;
  }

  private boolean rests(ControllerState state) {
    Optional<Joints> wantedRad = Optional.of(state.arm().targetPositionRad());
    looks = wantedRad.equals(targetRad) ? Math.min(looks + 1, SETTLING_LOOKS) : 0;
    targetRad = wantedRad;
    return state.armRests() || looks == SETTLING_LOOKS;
  }
}
