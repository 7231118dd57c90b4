package org.pendant.models.shape;

/**
 * The shoulder or a wrist: a cylinder about the joint that moves it (z), crossed by one about the
 * next joint (y). The next joint's axis points along negative y on the shoulder and wrist 1, along
 * y on wrist 2; wrist 3 has none, across it is the socket of the tool's cable.
 *
 * @param alongZ about the joint that moves it
 * @param alongY across; its radius was not measured apart and is that of {@code alongZ}
 */
public record JointHousing(Cylinder alongZ, Cylinder alongY) {}
