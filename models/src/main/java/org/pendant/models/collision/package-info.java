/**
 * How far the links of an arm are from one another and from what stands around it. Open {@link
 * org.pendant.models.collision.ArmClearance} first; {@link
 * org.pendant.models.collision.LinkCapsules} says what a link is made of.
 */
package org.pendant.models.collision;
