package org.pendant.motion;

import org.pendant.models.arm.Joints;

/** Motion plan: makes a motion as soon as it is known where it begins. */
@FunctionalInterface
public interface MotionPlan {
  /**
   * Plans from a state of the target.
   *
   * @param positionRad joint positions, rad
   * @param speedRadPerS joint speeds, rad/s; zero unless the motion takes over from another
   * @throws PlanningException when there is no such motion
   */
  Motion from(Joints positionRad, Joints speedRadPerS) throws PlanningException;
}
