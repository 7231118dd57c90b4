package org.pendant.motion.servo;

import org.pendant.models.arm.Joints;

/**
 * Torque setpoint: torques that the motors add to those that carry the arm's own weight and the
 * declared payload (manual 15.2).
 *
 * @param torqueNm added at each joint, Nm
 * @param friction how much of their friction the motors overcome
 */
public record TorqueSetpoint(Joints torqueNm, FrictionShare friction) {
  /** Nothing is added. */
  public static final TorqueSetpoint ZERO = new TorqueSetpoint(Joints.ZERO, FrictionShare.MOST);
}
