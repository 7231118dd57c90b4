package org.pendant.controller.state;

import org.pendant.models.arm.Joints;

/**
 * Supply voltages, as the control box reads them.
 *
 * @param boxV of the supply of the control box, V
 * @param robotV at the arm, V; 0 without power
 * @param jointV at each joint, V; 0 without power
 */
public record SupplyVoltages(double boxV, double robotV, Joints jointV) {}
