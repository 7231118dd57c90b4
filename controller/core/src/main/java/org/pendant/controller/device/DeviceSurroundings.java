package org.pendant.controller.device;

import org.pendant.controller.wire.SignalLines;
import org.pendant.controller.world.ContactWorld;

/**
 * Surroundings of devices: what they see and touch, and where their wires lead.
 *
 * @param world what grippers grip in
 * @param tools where tool centre points are
 * @param encoders what belts turn
 * @param lines what there is besides the signals of the devices themselves
 */
public record DeviceSurroundings(
    ContactWorld world, ToolPlaces tools, EncoderTicks encoders, SignalLines lines) {}
