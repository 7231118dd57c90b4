package org.pendant.controller.arm;

import org.pendant.models.arm.Joints;

/** An arm that follows joint targets, one step a frame. */
public interface SimulatedArm {

  /**
   * Advances by one frame.
   *
   * @param targetPositionRad where the joints should be at the end of the frame, rad
   * @param targetSpeedRadPerS how fast they should turn then, rad/s
   */
  void step(Joints targetPositionRad, Joints targetSpeedRadPerS);

  /** Puts the arm elsewhere, at rest; only a simulation can (manual 15.46). */
  void jumpTo(Joints positionRad);

  /** Joint positions as the encoders would read them, rad. */
  Joints positionRad();

  /** Joint speeds, rad/s. */
  Joints speedRadPerS();
}
