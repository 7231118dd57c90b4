package org.pendant.controller.motion;

import org.pendant.controller.motion.profile.Profile;
import org.pendant.controller.motion.profile.ProfileLimits;
import org.pendant.controller.value.ScriptError;
import org.pendant.models.arm.Joints;

/**
 * A move as a program asks for it: where to, how fast, and how near to its goal the next move may
 * take over.
 *
 * @param route the path, once it is known where it begins
 * @param blendRadiusM of the sphere around the goal in which the path may be left, m, 0 or more
 * @param jerkRampS how long the acceleration takes to grow to its limit, s; 0 for at once, as in
 *     motion version 1 (manual 14)
 */
public record Move(Route route, MoveLimits limits, double blendRadiusM, double jerkRampS) {

  /** Makes the path of a move. */
  @FunctionalInterface
  public interface Route {
    /**
     * The path.
     *
     * @param from joint positions at its begin, rad
     * @throws ScriptError when there is none
     */
    MotionPath from(Joints from) throws ScriptError;
  }

  /** Checks the numbers. */
  public Move {
    if (!(blendRadiusM >= 0 && jerkRampS >= 0)) {
      throw new IllegalArgumentException(
          "blend radius is "
              + blendRadiusM
              + ", jerk ramp "
              + jerkRampS
              + ", must not be negative");
    }
  }

  /** Whether acceleration grows and fades rather than jumps. */
  boolean smooth() {
    return jerkRampS > 0;
  }

  /** How much stronger than even acceleration the peak is in a blend. */
  double peakOverMean() {
    return smooth() ? 1.5 : 1;
  }

  /** The limits on a path, of which {@code restingEnds} ends are at rest. */
  ProfileLimits limits(MotionPath path, int restingEnds) {
    ProfileLimits even = limits.over(path.length(), restingEnds, path.fastestRate());
    return smooth()
        ? new ProfileLimits(even.speed(), even.acceleration(), even.acceleration() / jerkRampS)
        : even;
  }

  /** The law for the whole of a path from rest to rest. */
  Profile restToRest(MotionPath path) {
    double length = path.length();
    ProfileLimits within = limits(path, 2);
    if (length == 0 || !limits.timed()) {
      return within.over(length);
    }
    Profile timed = within.withDuration(length, limits.durationS());
    return timed.peakSpeed() > path.fastestRate() ? within.over(length) : timed;
  }
}
