package org.pendant.models.identification;

import org.pendant.models.arm.Joints;

/**
 * Arm sample: a motion and what the drives had to give for it, at one moment.
 *
 * @param positionRad of the joints, rad
 * @param speedRadPerS of the joints, rad/s
 * @param accelerationRadPerS2 of the joints, rad/s²
 * @param momentNm what links, payload and rotors need, without friction, Nm
 */
public record ArmSample(
    Joints positionRad, Joints speedRadPerS, Joints accelerationRadPerS2, Joints momentNm) {}
