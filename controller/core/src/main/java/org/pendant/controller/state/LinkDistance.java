package org.pendant.controller.state;

/** Link distance: how near a link of the arm is to another link, or to what stands around it. */
@FunctionalInterface
public interface LinkDistance {
  /** The distance where the arm is, m: below 0 by the depth inside. Any thread may ask. */
  double nearestM(ArmState arm);
}
