package org.pendant.controller.box;

import org.pendant.models.dynamics.ArmDynamics;

/**
 * Mounting: how the base is mounted and moves, as the controller believes it; all along the axes of
 * the base (manual 16.44, 16.48).
 *
 * @param gravityXMPerS2 what the resting arm feels, m/s²
 * @param gravityYMPerS2 the same along y, m/s²
 * @param gravityZMPerS2 the same along z, m/s²; 9.82 on the floor
 * @param accelerationXMPerS2 acceleration of the base, m/s²
 * @param accelerationYMPerS2 the same along y, m/s²
 * @param accelerationZMPerS2 the same along z, m/s²
 */
public record Mounting(
    double gravityXMPerS2,
    double gravityYMPerS2,
    double gravityZMPerS2,
    double accelerationXMPerS2,
    double accelerationYMPerS2,
    double accelerationZMPerS2) {
  /** On the floor, at rest. */
  static final Mounting FLOOR = new Mounting(0, 0, ArmDynamics.STANDARD_GRAVITY_M_PER_S2, 0, 0, 0);
}
