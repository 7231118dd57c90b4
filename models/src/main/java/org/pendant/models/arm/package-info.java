/**
 * Arm models as data: lengths, limits, masses, and the six numbers of a joint vector. Open {@link
 * org.pendant.models.arm.ArmDescription} first.
 */
package org.pendant.models.arm;
