/**
 * Shapes of arms, as cylinders simple enough to draw and to keep clear of. Open {@link
 * org.pendant.models.shape.ArmShape} first; {@link org.pendant.models.shape.ArmShapes} loads one.
 */
package org.pendant.models.shape;
