package org.pendant.models.arm;

/**
 * Link geometry of one arm as a calibration tells it: how each joint's axis lies to that before it.
 */
public sealed interface LinkGeometry permits DhDeltas, LinkFrames {}
