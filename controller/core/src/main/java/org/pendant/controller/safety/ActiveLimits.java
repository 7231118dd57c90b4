package org.pendant.controller.safety;

import java.util.List;
import org.pendant.models.arm.ArmDescription;

/**
 * Active limits: which safety limits apply at the moment: normal, reduced by an input or beyond a
 * trigger plane, or those of recovery. After the input both sets are accepted for a while; before a
 * trigger plane the arm is slowed down, so that it passes slowly enough.
 */
final class ActiveLimits {
  /** How long both sets are accepted after the input demands the reduced one, s. */
  static final double BOTH_ACCEPTED_S = 0.5;

  /** How far back on the normal side of a trigger plane the normal limits hold again, m. */
  static final double TRIGGER_BAND_M = 0.02;

  /** From this far before a trigger plane on the arm slows down, m. */
  private static final double SLOWING_M = 0.2;

  /** How long it takes to slow down when the input comes, s; well within the time allowed. */
  private static final double HARD_SLOWING_S = 0.15;

  private static final double SOFT_SLOWING_S = 0.45;

  /** Share of a frame that sums of frame times may be off. */
  private static final double ROUNDING_S = 1e-6;

  private final SafetyLimits recoverySet;
  private SafetyConfiguration configuration;
  private List<SafetyPlane> triggers;
  private boolean byInput;
  private boolean byPlane;
  private boolean recovery;
  private boolean soft;
  private double nowS;
  private double inputSinceS = Double.NEGATIVE_INFINITY;

  ActiveLimits(ArmDescription arm, SafetyConfiguration configuration) {
    this.configuration = configuration;
    recoverySet = StandardLimits.recovery(StandardLimits.normal(arm));
    triggers = triggers(configuration);
  }

  private static List<SafetyPlane> triggers(SafetyConfiguration configuration) {
    return configuration.planes().stream()
        .filter(plane -> plane.applies() == Applies.TRIGGERS_REDUCED)
        .toList();
  }

  /** Other limits hold from now on. */
  void configure(SafetyConfiguration other) {
    configuration = other;
    triggers = triggers(other);
  }

  /**
   * Looks at a new frame.
   *
   * @param reducedDemanded whether the input demands the reduced limits
   */
  void update(double timeS, boolean reducedDemanded, ArmPoints actual) {
    nowS = timeS;
    if (reducedDemanded && !byInput) {
      inputSinceS = byPlane ? Double.NEGATIVE_INFINITY : timeS;
    }
    byInput = reducedDemanded;
    boolean beyond = false;
    for (int i = 0; i < triggers.size(); i++) {
      beyond |= triggers.get(i).insideM(actual) < (byPlane ? TRIGGER_BAND_M : 0);
    }
    byPlane = beyond;
  }

  void setSoft(boolean soft) {
    this.soft = soft;
  }

  boolean soft() {
    return soft;
  }

  void setRecovery(boolean recovery) {
    this.recovery = recovery;
  }

  boolean recovery() {
    return recovery;
  }

  boolean reduced() {
    return byInput || byPlane;
  }

  /** Whether the reduced limits are checked, not only aimed at. */
  boolean reducedChecked() {
    return byPlane || (byInput && nowS - inputSinceS > BOTH_ACCEPTED_S - ROUNDING_S);
  }

  /** The set that holds. */
  SafetyLimits active() {
    return set(reduced());
  }

  /** The set that is checked. */
  SafetyLimits checked() {
    return set(reducedChecked());
  }

  /** The set of the configuration that holds once the arm is within its limits. */
  SafetyLimits configuredActive() {
    return reduced() ? configuration.reduced() : configuration.normal();
  }

  /** The set of the configuration that is checked once the arm is within its limits. */
  SafetyLimits configured() {
    return reducedChecked() ? configuration.reduced() : configuration.normal();
  }

  /** The set that holds as long as the reduced one does not. */
  SafetyLimits unreduced() {
    return set(false);
  }

  private SafetyLimits set(boolean reducedOne) {
    if (recovery) {
      return recoverySet;
    }
    return reducedOne ? configuration.reduced() : configuration.normal();
  }

  /** The reduced set, or that of recovery. */
  SafetyLimits reducedSet() {
    return set(true);
  }

  /** Whether a position may matter to {@link #reducedShare}. */
  boolean hasTriggers() {
    return !triggers.isEmpty();
  }

  /** How far the arm should be slowed down from normal (0) to reduced (1) in a position. */
  double reducedShare(ArmPoints points) {
    double share = byPlane ? 1 : inputShare();
    for (int i = 0; i < triggers.size(); i++) {
      double beforeM = triggers.get(i).insideM(points) - TRIGGER_BAND_M;
      share = Math.max(share, 1 - beforeM / (SLOWING_M - TRIGGER_BAND_M));
    }
    return Math.min(1, share);
  }

  private double inputShare() {
    return byInput
        ? Math.max(0, (nowS - inputSinceS) / (soft ? SOFT_SLOWING_S : HARD_SLOWING_S))
        : 0;
  }
}
