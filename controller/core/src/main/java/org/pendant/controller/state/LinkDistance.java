package org.pendant.controller.state;

import org.pendant.controller.world.LinkDistances;

/**
 * Link distance: how near the links of an arm are to one another, to what stands around it, and to
 * other arms.
 */
@FunctionalInterface
public interface LinkDistance {
  /** The distances where the arm is. Any thread may ask. */
  LinkDistances of(ArmState arm);
}
