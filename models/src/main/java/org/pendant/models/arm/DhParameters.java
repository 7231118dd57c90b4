package org.pendant.models.arm;

/**
 * Denavit-Hartenberg parameters of all six joints, in the convention of {@link DhLengths}: {@code
 * T_i = Rz(q_i + thetaRad_i) Tz(dM_i) Tx(aM_i) Rx(alphaRad_i)}.
 *
 * @param thetaRad added to the joint positions, rad
 * @param aM lengths along the x axes, m
 * @param dM lengths along the joints' axes, m
 * @param alphaRad angles between the joints' axes, rad
 */
public record DhParameters(Joints thetaRad, Joints aM, Joints dM, Joints alphaRad) {}
