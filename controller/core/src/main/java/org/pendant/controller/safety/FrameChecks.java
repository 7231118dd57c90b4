package org.pendant.controller.safety;

import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.ArmDynamics;

/** Frame checks: all that is checked in a frame, in the order in which it counts. */
final class FrameChecks {
  private final Observation seen;
  private final ViolationCheck violations;
  private final PressCheck press = new PressCheck();
  private final TargetCheck target;
  private final TravelCheck travel;
  private final FollowingCheck following;
  private final DeviationWarnings warnings;

  /**
   * Checks of a configuration.
   *
   * @param warnings that were asked for
   */
  FrameChecks(
      ArmDescription arm,
      ArmDynamics dynamics,
      SafetyConfiguration configuration,
      DeviationWarnings warnings) {
    boolean targetMatters =
        !configuration.planes().isEmpty() || configuration.toolDirection().isPresent();
    seen = new Observation(arm, dynamics, targetMatters);
    violations = new ViolationCheck(configuration);
    target = new TargetCheck(arm);
    travel = new TravelCheck(configuration);
    following = new FollowingCheck(arm);
    this.warnings = warnings;
  }

  /** Takes in a frame; {@link #fault} comes next. */
  void take(FrameFacts facts) {
    seen.take(facts);
  }

  /** A number without which nothing can be checked is none; otherwise the frame is evaluated. */
  Optional<SafetyStop> fault(FrameFacts facts) {
    OptionalInt joint = seen.jointWithoutNumber();
    if (joint.isPresent()) {
      return Optional.of(StopReason.NO_READING.ofJoint(joint.getAsInt(), facts.timeS(), 0, 0));
    }
    seen.evaluate(facts);
    return Optional.empty();
  }

  /** Momentum of arm and declared payload, kg m/s. */
  double momentumKgMPerS() {
    return seen.momentumKgMPerS();
  }

  /** How far the arm is on its way to a stop for not following its target, 0 to 1. */
  double deviationRatio() {
    return following.deviationRatio();
  }

  /** How far it is on its way to a stop for being pushed, 0 to 1. */
  double collisionRatio() {
    return following.collisionRatio();
  }

  /** Tool and elbow of the actual arm. */
  ArmPoints actual() {
    return seen.actual;
  }

  /** What was seen before belongs to another situation. */
  void forget() {
    target.forget();
    restart();
  }

  /** What has lasted for some frames begins to count from now. */
  void restart() {
    press.reset();
    following.reset();
  }

  DeviationWarnings warnings() {
    return warnings;
  }

  /** Where the arm is beyond the configured limits; {@code tolerance} is 0 or 1. */
  Optional<SafetyStop> beyond(double timeS, ActiveLimits limits, double tolerance) {
    return violations.position(
        timeS, seen.q, seen.actual, limits.configured(), limits.reducedChecked(), tolerance);
  }

  /**
   * A limit that the arm exceeds.
   *
   * @param stopped whether a stop is present: what presses then was there before and is being dealt
   *     with
   */
  Optional<SafetyStop> violation(FrameFacts facts, ActiveLimits limits, boolean stopped) {
    Optional<SafetyStop> found =
        limits.recovery() ? Optional.empty() : beyond(facts.timeS(), limits, 1);
    if (found.isEmpty()) {
      found = violations.motion(facts.timeS(), seen, limits.checked());
    }
    if (found.isEmpty() && !stopped) {
      found = press.check(facts, seen, limits.checked());
    }
    return found;
  }

  /** Takes the target as it is: nothing is expected of it in this frame. */
  void acceptTarget() {
    target.remember(seen);
  }

  /** The protective stop that was asked for, if one was. */
  Optional<SafetyStop> requested(AskedStops asked, FrameFacts facts, SafetyLimits limits) {
    return asked.first(facts, seen, limits);
  }

  /** What calls for a protective stop. */
  Optional<SafetyStop> protective(FrameFacts facts, ActiveLimits limits, boolean holding) {
    Optional<SafetyStop> found =
        facts.guided() ? guided(facts, limits) : planned(facts, limits, holding);
    travel.remember(seen);
    return found;
  }

  private Optional<SafetyStop> guided(FrameFacts facts, ActiveLimits limits) {
    // the target is where the arm is, so it may do anything, and a push is no collision
    forget();
    if (limits.recovery()) {
      return Optional.empty();
    }
    Optional<SafetyStop> found =
        travel.check(facts.timeS(), seen, limits.checked(), limits.reducedChecked());
    return found.isPresent() ? found : travel.joints(facts.timeS(), seen, limits.checked());
  }

  private Optional<SafetyStop> planned(FrameFacts facts, ActiveLimits limits, boolean holding) {
    Optional<SafetyStop> found = target.check(facts.timeS(), seen);
    if (found.isEmpty() && !limits.recovery()) {
      found = travel.check(facts.timeS(), seen, limits.checked(), limits.reducedChecked());
    }
    if (found.isEmpty()) {
      found = following.check(facts, seen, holding);
    }
    return found;
  }

  /** A joint that is worth a warning. */
  Optional<SafetyStop> warning(FrameFacts facts, boolean holding) {
    return warnings.check(facts.timeS(), seen, holding);
  }
}
