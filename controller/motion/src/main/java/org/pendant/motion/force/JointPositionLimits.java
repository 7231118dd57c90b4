package org.pendant.motion.force;

import org.pendant.models.arm.Joints;

/** Joint position limits: the range in which each joint must stay. */
public interface JointPositionLimits {
  /** The smallest position of each joint, rad; minus infinity for none. */
  Joints jointMinRad();

  /** The largest position of each joint, rad; infinity for none. */
  Joints jointMaxRad();
}
