package org.pendant.controller.device;

import org.pendant.controller.device.gripper.FingerSpace;
import org.pendant.controller.world.FingerHand;

/** Bodies between the fingers of a gripper: the objects of the scene that can move. */
record BodiesBetween(FingerHand hand) implements FingerSpace {
  @Override
  public double closesToM(double openingM, double forceN) {
    return hand.closesToM(openingM, forceN);
  }

  @Override
  public void press(double openingM, double forceN) {
    hand.press(openingM, forceN);
  }
}
