package org.pendant.controller.device;

import org.pendant.controller.device.gripper.FingerSpace;
import org.pendant.controller.world.ParallelGripper;

/**
 * Bodies between the fingers of a gripper, or around them: the objects of the scene that can move.
 */
record BodiesBetween(ParallelGripper gripper) implements FingerSpace {
  @Override
  public double closesToM(double openingM, double forceN) {
    return gripper.closesToM(openingM, forceN);
  }

  @Override
  public double opensToM(double openingM, double forceN) {
    return gripper.opensToM(openingM, forceN);
  }

  @Override
  public void press(double openingM, double forceN) {
    gripper.press(openingM, forceN);
  }
}
