package org.pendant.desktop.move;

import org.pendant.models.arm.JointLimits;

/**
 * Joint range: the range of a joint as it is drawn: one that turns without end gets a turn either
 * way.
 *
 * @param minRad smallest position, rad
 * @param maxRad largest position, rad
 * @param unlimited whether the joint turns without end
 */
record JointRange(double minRad, double maxRad, boolean unlimited) {
  /** What the arm and the limits {@code lowestRad} and {@code highestRad} allow both. */
  static JointRange of(JointLimits limits, double lowestRad, double highestRad) {
    double min = Math.max(limits.lowestRad(), lowestRad);
    double max = Math.min(limits.highestRad(), highestRad);
    return Double.isInfinite(min) || Double.isInfinite(max)
        ? new JointRange(-2 * Math.PI, 2 * Math.PI, true)
        : new JointRange(min, max, false);
  }

  /** Where a position is in the range: 0 at its start, 1 at its end; never outside. */
  double share(double positionRad) {
    double shown = unlimited ? Math.IEEEremainder(positionRad, 2 * maxRad) : positionRad;
    return Math.max(0, Math.min(1, (shown - minRad) / (maxRad - minRad)));
  }

  boolean contains(double positionRad) {
    return unlimited || (positionRad >= minRad && positionRad <= maxRad);
  }
}
