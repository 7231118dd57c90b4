package org.pendant.controller.state;

/**
 * Link distance: how near a link of the arm is to another link, to what stands around it, or to
 * another arm.
 */
@FunctionalInterface
public interface LinkDistance {
  /** The distance where the arm is, m: below 0 by the depth inside. Any thread may ask. */
  double nearestM(ArmState arm);
}
