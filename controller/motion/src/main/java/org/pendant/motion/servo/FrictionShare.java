package org.pendant.motion.servo;

import org.pendant.models.arm.Joints;

/**
 * Friction compensation: how much of its friction each motor overcomes.
 *
 * @param viscous of what grows with the speed, 0 to 1
 * @param coulomb of dry friction, 0 to 1
 */
public record FrictionShare(Joints viscous, Joints coulomb) {
  private static final Joints MOSTLY = new Joints(0.8, 0.8, 0.8, 0.8, 0.8, 0.8);

  /** Most of it: not all, or the arm would drift. */
  public static final FrictionShare MOST = new FrictionShare(MOSTLY, MOSTLY);

  public static final FrictionShare NONE = new FrictionShare(Joints.ZERO, Joints.ZERO);
}
