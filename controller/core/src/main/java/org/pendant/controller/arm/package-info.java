/**
 * Simulated arms: what joints, drives, brakes and sensors do when the controller gives targets or
 * torques. Open {@link org.pendant.controller.arm.SimulatedArm} first, then {@link
 * org.pendant.controller.arm.DynamicArm}.
 */
package org.pendant.controller.arm;
